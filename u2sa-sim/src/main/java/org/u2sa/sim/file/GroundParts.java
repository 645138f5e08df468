package org.u2sa.sim.file;

import java.util.SplittableRandom;
import org.u2sa.sim.ground.BatteryParameters;
import org.u2sa.sim.ground.MotorParameters;
import org.u2sa.sim.ground.TyreParameters;

/** Parts that ground vehicles have in common. */
final class GroundParts {
  private GroundParts() {}

  static MotorParameters motor(FileElement motor) {
    MotorParameters made =
        motor.made(
            () ->
                new MotorParameters(
                    motor.positive("ratedVoltage", "V", 1_000.0),
                    motor.positive("freeSpeed", "rad/s", 10_000.0),
                    motor.number("freeCurrent", "A", 0.0, 10_000.0),
                    motor.positive("stallTorque", "N m", 100_000.0),
                    motor.positive("stallCurrent", "A", 10_000.0),
                    motor.positive("inertia", "kg m^2", 1_000.0),
                    motor.number("deadBand", "1", 0.0, 0.5)));
    motor.end();
    return made;
  }

  static TyreParameters tyre(FileElement tyre) {
    TyreParameters made =
        tyre.made(
            () ->
                new TyreParameters(
                    tyre.number("slipStiffness", "1", 0.5, 100.0),
                    tyre.number("relaxation", "m", 0.005, 10.0),
                    tyre.number("damping", "s", 0.001, 1.0),
                    tyre.number("patchRadius", "m", 0.001, 1.0)));
    tyre.end();
    return made;
  }

  static BatteryParameters battery(FileElement battery) {
    BatteryParameters made =
        battery.made(
            () ->
                new BatteryParameters(
                    battery.positive("fullVoltage", "V", 1_000.0),
                    battery.positive("emptyVoltage", "V", 1_000.0),
                    battery.number("resistance", "Ohm", 0.0, 10.0),
                    battery.positive("capacity", "Ah", 1e6),
                    battery.number("idleCurrent", "A", 0.0, 100.0)));
    battery.end();
    return made;
  }

  /**
   * The mismatch of a vehicle's motors, uniformly distributed and different for every seed.
   *
   * @param largest its maximum, 0…0.5
   */
  static double mismatch(double largest, long seed) {
    return new SplittableRandom(seed).nextDouble() * 2.0 * largest - largest;
  }
}
