package org.u2sa.sim.sensor;

/** Refuses parameters that no sensor has. */
final class Arguments {
  private Arguments() {}

  static void requireInside(String name, double value, double lowest, double highest) {
    if (!(value >= lowest && value <= highest)) {
      throw new IllegalArgumentException(
          name + ": " + value + " is outside " + lowest + "…" + highest);
    }
  }

  static void requirePositive(String name, double value) {
    if (!(value > 0.0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(name + ": " + value + " is not above 0");
    }
  }
}
