package org.u2sa.scenarios.roboboat;

import java.util.Optional;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.scenarios.roboboat.subvehicle.QuadrotorOnDeck;
import org.u2sa.scenarios.roboboat.subvehicle.SubVehicle;
import org.u2sa.service.ServiceContext;

/**
 * Devices of a simulated boat.
 *
 * @param vehicle those of its vehicle file
 * @param quadrotor on its deck
 * @param radioFails whether nothing is heard of the quadrotor
 */
record BoatDevices(
    ServiceContext.DeviceSource vehicle,
    QuadrotorOnDeck quadrotor,
    boolean radioFails)
    implements ServiceContext.DeviceSource {
  @Override
  public <D> Optional<D> device(
      Class<D> port, String service, XmlConfiguration variables, Clock clock) {
    if (port == SubVehicle.class) {
      SubVehicle radio = () -> radioFails ? new LocalBus("nobody") : quadrotor.switchOn(clock);
      return Optional.of(port.cast(radio));
    }
    return vehicle.device(port, service, variables, clock);
  }
}
