package org.u2sa.sim.aircraft;

/** Refuses arguments that physics has no answer to. */
final class Arguments {
  private Arguments() {}

  static void requireInside(String name, double value, double lowest, double highest) {
    if (!(value >= lowest && value <= highest)) {
      throw new IllegalArgumentException(
          name + ": " + value + " is outside " + lowest + "…" + highest);
    }
  }
}
