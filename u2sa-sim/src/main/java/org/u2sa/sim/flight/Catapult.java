package org.u2sa.sim.flight;

import org.u2sa.sim.motion.Arguments;

/**
 * Launches an aircraft by catapult, bungee or hand once its motor runs.
 *
 * @param speedMps speed over ground of the aircraft when it leaves [m/s]
 * @param angleRad above the horizon, which is also its pitch [rad]
 * @param heightM height of the centre of gravity above ground before launch [m]
 * @param strokeM acceleration distance [m]
 */
public record Catapult(double speedMps, double angleRad, double heightM, double strokeM) {
  /** Throttle above which it launches. */
  static final double RUNS_ABOVE = 0.5;

  /**
   * @throws IllegalArgumentException if a value is out of range
   */
  public Catapult {
    Arguments.requireInside("speed of a catapult [m/s]", speedMps, 0.1, 200.0);
    Arguments.requireInside("angle of a catapult [rad]", angleRad, 0.0, StrictMath.PI / 3.0);
    Arguments.requireInside("height of a catapult [m]", heightM, 0.0, 1_000.0);
    Arguments.requireInside("stroke of a catapult [m]", strokeM, 0.1, 1_000.0);
  }

  /** Constant acceleration along the stroke [m/s²]. */
  double accelerationMps2() {
    return speedMps * speedMps / (2.0 * strokeM);
  }
}
