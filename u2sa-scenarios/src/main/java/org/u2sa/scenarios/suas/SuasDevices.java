package org.u2sa.scenarios.suas;

import java.util.Optional;
import org.u2sa.device.port.Camera;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.vehicle.RunningVehicle;

/**
 * Devices of the simulated aircraft.
 *
 * @param vehicle those of its vehicle file
 * @param camera under it
 * @param run the vehicle
 * @param cameraFailsS time at which the camera fails [s]; infinite for never
 */
record SuasDevices(
    ServiceContext.DeviceSource vehicle,
    SurveyPictures camera,
    RunningVehicle run,
    double cameraFailsS)
    implements ServiceContext.DeviceSource {
  @Override
  public <D> Optional<D> device(
      Class<D> port, String service, XmlConfiguration variables, Clock clock) {
    if (port != Camera.class) {
      return vehicle.device(port, service, variables, clock);
    }
    camera.failAt(cameraFailsS, () -> run.at(clock.micros()).timeS());
    return Optional.of(port.cast(camera));
  }
}
