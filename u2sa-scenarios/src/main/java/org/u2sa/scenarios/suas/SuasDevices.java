package org.u2sa.scenarios.suas;

import java.util.Optional;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.RadioReceiver;
import org.u2sa.device.port.Servo;
import org.u2sa.device.port.Thruster;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.vehicle.RunningVehicle;

/**
 * Devices of the simulated aircraft.
 *
 * @param vehicle devices of its vehicle file
 * @param camera camera below the aircraft
 * @param run the vehicle
 * @param cameraFailsS time at which the camera fails [s]; infinite for never
 * @param pilot pilot with the radio
 */
record SuasDevices(
    ServiceContext.DeviceSource vehicle,
    SurveyPictures camera,
    RunningVehicle run,
    double cameraFailsS,
    SuasPilot pilot)
    implements ServiceContext.DeviceSource {
  @Override
  public <D> Optional<D> device(
      Class<D> port, String service, XmlConfiguration variables, Clock clock) {
    if (port == RadioReceiver.class) {
      return Optional.of(port.cast(pilot.receiver()));
    }
    if (port != Camera.class) {
      return vehicle.device(port, service, variables, clock).map(own -> behindRadio(service, own));
    }
    camera.failAt(cameraFailsS, () -> run.at(clock.micros()).timeS());
    return Optional.of(port.cast(camera));
  }

  /** Puts servos and motor behind the radio's multiplexer; leaves other devices unchanged. */
  @SuppressWarnings("unchecked") // each wrapper is of the same port
  private <D> D behindRadio(String service, D own) {
    if (own instanceof Servo servo) {
      return (D) pilot.servo(service, servo);
    }
    return own instanceof Thruster motor ? (D) pilot.motor(motor) : own;
  }
}
