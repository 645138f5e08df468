package org.u2sa.sim.ground;

/** Refuses arguments that physics has no answer to. */
final class Arguments {
  private Arguments() {}

  static double requireInside(String name, double value, double lowest, double highest) {
    if (!(value >= lowest && value <= highest)) {
      throw new IllegalArgumentException(
          name + ": " + value + " is outside " + lowest + "…" + highest);
    }
    return value;
  }

  static double requirePositive(String name, double value) {
    if (!(value > 0.0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(name + ": " + value + " is not above 0");
    }
    return value;
  }

  static double requireFinite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + ": " + value + " is not a number");
    }
    return value;
  }
}
