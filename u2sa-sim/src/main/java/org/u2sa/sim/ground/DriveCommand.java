package org.u2sa.sim.ground;

/**
 * Commands of a vehicle's two inputs, each −1…1, or NaN without pulses: the motor coasts, or the
 * unpowered steering servo keeps its angle.
 *
 * @param first left wheel of a differential vehicle, or throttle with Ackermann steering; forward
 *     positive
 * @param second right wheel, forward positive; or steering, right positive
 */
public record DriveCommand(double first, double second) {
  private static final DriveCommand NONE = new DriveCommand(Double.NaN, Double.NaN);
  private static final DriveCommand NEUTRAL = new DriveCommand(0.0, 0.0);

  /**
   * @throws IllegalArgumentException if a number is outside −1…1
   */
  public DriveCommand {
    require("first", first);
    require("second", second);
  }

  /** No pulses: motors off. */
  public static DriveCommand none() {
    return NONE;
  }

  /** Neutral pulses: motors brake, steering straight. */
  public static DriveCommand neutral() {
    return NEUTRAL;
  }

  private static void require(String name, double value) {
    if (Math.abs(value) > 1.0) {
      throw new IllegalArgumentException(name + ": " + value + " is outside -1.0…1.0");
    }
  }
}
