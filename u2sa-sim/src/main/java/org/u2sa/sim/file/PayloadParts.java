package org.u2sa.sim.file;

import java.util.Map;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedLoadCell;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.payload.SimulatedGimbal;
import org.u2sa.sim.payload.SimulatedServo;
import org.u2sa.sim.payload.SimulatedSwitch;

/** Payloads of a vehicle file, and their sensors. */
final class PayloadParts {
  private PayloadParts() {}

  static SensorKinds.Reader gimbal(FileElement file) {
    SimulatedGimbal.Drive drive =
        new SimulatedGimbal.Drive(
            file.number("rate", "Hz", 0.1, 1_000.0),
            file.number("pan", "rad", 0.0, 2.0 * Math.PI),
            file.number("lowestTilt", "rad", -Math.PI, 0.0),
            file.number("highestTilt", "rad", 0.0, Math.PI),
            file.positive("maxRate", "rad/s", 1_000.0),
            file.positive("lag", "s", 60.0));
    return new SensorKinds.Reader(
        Map.of(
            "MINIMUM PAN", -drive.panRad() + 0.0,
            "MAXIMUM PAN", drive.panRad(),
            "MINIMUM TILT", drive.lowestTiltRad(),
            "MAXIMUM TILT", drive.highestTiltRad()),
        vehicle -> new SimulatedGimbal(drive));
  }

  static SensorKinds.Reader servo(FileElement file) {
    double rate = file.number("rate", "Hz", 0.1, 1_000.0);
    double lowest = file.number("lowest", "rad", -2.0 * Math.PI, 0.0);
    double highest = file.number("highest", "rad", 0.0, 2.0 * Math.PI);
    double maxRate = file.positive("maxRate", "rad/s", 1_000.0);
    double lag = file.positive("lag", "s", 60.0);
    return new SensorKinds.Reader(
        Map.of("TRAVEL", Math.max(-lowest, Math.max(0.01, highest))),
        vehicle -> new SimulatedServo(rate, lowest, highest, maxRate, lag));
  }

  static SensorKinds.Reader output(FileElement file) {
    double rate = file.number("rate", "Hz", 0.1, 1_000.0);
    double time = file.number("time", "s", 0.0, 60.0);
    return new SensorKinds.Reader(vehicle -> new SimulatedSwitch(rate, time));
  }

  static SensorKinds.Reader loadCell(FileElement file) {
    SensorErrors errors = StateSensors.errors(file, "N");
    String thruster = file.text("thruster");
    return new SensorKinds.Reader(
        vehicle -> {
          if (vehicle.thrustN().apply(thruster).isEmpty()) {
            throw file.xml()
                .error("thruster: no thruster \"" + thruster + "\" whose thrust is computed");
          }
          return new SimulatedLoadCell(
              errors, vehicle.streams(), () -> vehicle.thrustN().apply(thruster).orElse(0.0));
        });
  }
}
