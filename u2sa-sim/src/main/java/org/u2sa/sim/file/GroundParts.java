package org.u2sa.sim.file;

import java.util.SplittableRandom;
import org.u2sa.sim.file.element.FileElement;
import org.u2sa.sim.ground.BatteryParameters;
import org.u2sa.sim.ground.MotorParameters;
import org.u2sa.sim.ground.Payload;
import org.u2sa.sim.ground.TyreParameters;

/** Parts common to ground vehicles. */
final class GroundParts {
  private GroundParts() {}

  static MotorParameters motor(FileElement motor) {
    return motor.complete(
        () ->
            new MotorParameters(
                motor.positive("ratedVoltage", "V", 1_000.0),
                motor.positive("freeSpeed", "rad/s", 10_000.0),
                motor.number("freeCurrent", "A", 0.0, 10_000.0),
                motor.positive("stallTorque", "N m", 100_000.0),
                motor.positive("stallCurrent", "A", 10_000.0),
                motor.positive("inertia", "kg m^2", 1_000.0),
                motor.number("deadBand", "1", 0.0, 0.5)));
  }

  static TyreParameters tyre(FileElement tyre) {
    return tyre.complete(
        () ->
            new TyreParameters(
                tyre.number("slipStiffness", "1", 0.5, 100.0),
                tyre.number("relaxation", "m", 0.005, 10.0),
                tyre.number("damping", "s", 0.001, 1.0),
                tyre.number("patchRadius", "m", 0.001, 1.0)));
  }

  static BatteryParameters battery(FileElement battery) {
    return battery.complete(
        () ->
            new BatteryParameters(
                battery.positive("fullVoltage", "V", 1_000.0),
                battery.positive("emptyVoltage", "V", 1_000.0),
                battery.number("resistance", "Ohm", 0.0, 10.0),
                battery.positive("capacity", "Ah", 1e6),
                battery.number("idleCurrent", "A", 0.0, 100.0)));
  }

  /** A mass above the centre of gravity, in addition to the body mass. */
  static Payload payload(FileElement file, Body body) {
    double mass = file.number("payload", "kg", 0.0, 1_000.0, 0.0);
    return new Payload(mass, body.gravityCentre().x(), 0.0);
  }

  /**
   * Mismatch: how much stronger the right motor is than the left.
   *
   * @param exact its value; NaN: drawn with the run's seed
   * @param largest limit of the drawn value, 0…0.5
   */
  record Mismatch(double exact, double largest) {
    /** Uniformly distributed over seeds unless exact. */
    double of(long seed) {
      return Double.isNaN(exact)
          ? new SplittableRandom(seed).nextDouble() * 2.0 * largest - largest
          : exact;
    }
  }

  static Mismatch mismatch(FileElement file) {
    return new Mismatch(
        file.number("exactMismatch", "1", -0.5, 0.5, Double.NaN),
        file.number("mismatch", "1", 0.0, 0.5, 0.0));
  }
}
