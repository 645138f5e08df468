package org.u2sa.control.cascade;

/**
 * Whether an aircraft is on the ground, where it must not lift its weight. It counts as airborne
 * once its target is above it or it moves, and as landed when it does not sink although commanded
 * to. Not thread-safe.
 */
final class GroundWatch {
  private static final double ABOVE_M = 0.3; // minimum height of a target that implies taking off
  private static final double MOVES_MPS = 1.0;
  private static final double SINKS_MPS = 0.1; // wanted at least
  private static final double STILL_MPS = 0.05;
  private static final double SURE_S = 1.0;

  private boolean stands = true;
  private double stillS;

  /**
   * Processes a step.
   *
   * @param toGoDownM vertical distance to the target, down positive [m]; 0 without one
   * @param wantedDownMps wanted vertical speed [m/s]
   * @param motion motion of the vehicle
   */
  void step(double toGoDownM, double wantedDownMps, BodyMotion motion, double stepS) {
    double speed = motion.velocity().distance();
    if (toGoDownM < -ABOVE_M || speed > MOVES_MPS) {
      flies();
      return;
    }
    boolean isStill = wantedDownMps > SINKS_MPS && speed < STILL_MPS;
    stillS = isStill ? stillS + stepS : 0.0;
    stands |= stillS > SURE_S;
  }

  boolean stands() {
    return stands;
  }

  /** The vehicle was in flight when its control was replaced. */
  void flies() {
    stands = false;
    stillS = 0.0;
  }

  /** The vehicle was disarmed. */
  void rest() {
    stands = true;
    stillS = 0.0;
  }
}
