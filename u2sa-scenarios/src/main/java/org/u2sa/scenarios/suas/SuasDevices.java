package org.u2sa.scenarios.suas;

import java.util.Optional;
import org.u2sa.device.port.Camera;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;

/**
 * Devices of the simulated aircraft.
 *
 * @param vehicle those of its vehicle file
 * @param camera under it
 */
record SuasDevices(ServiceContext.DeviceSource vehicle, Camera camera)
    implements ServiceContext.DeviceSource {
  @Override
  public <D> Optional<D> device(
      Class<D> port, String service, XmlConfiguration variables, Clock clock) {
    return port == Camera.class
        ? Optional.of(port.cast(camera))
        : vehicle.device(port, service, variables, clock);
  }
}
