package org.u2sa.sim.motion;

/** Validates arguments of models and devices. */
public final class Arguments {
  private Arguments() {}

  /**
   * The value.
   *
   * @throws IllegalArgumentException if it is outside the range or not a number
   */
  public static double requireInside(String name, double value, double lowest, double highest) {
    if (!(value >= lowest && value <= highest)) {
      throw new IllegalArgumentException(
          name + ": " + value + " is outside " + lowest + "…" + highest);
    }
    return value;
  }

  /**
   * The value.
   *
   * @throws IllegalArgumentException unless it is finite and above 0
   */
  public static double requirePositive(String name, double value) {
    if (!(value > 0.0 && Double.isFinite(value))) {
      throw new IllegalArgumentException(name + ": " + value + " is not above 0");
    }
    return value;
  }

  /**
   * The value.
   *
   * @throws IllegalArgumentException if it is infinite or not a number
   */
  public static double requireFinite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + ": " + value + " is not a number");
    }
    return value;
  }
}
