package org.u2sa.control.cascade;

/**
 * Drift of a vehicle that cannot move sideways, by wind and current: a velocity over ground, learnt
 * from the sideways velocity on different headings, besides the slip of its hull in turns. With the
 * bow turned against it, the course over ground is the wanted one (Fossen, Handbook of Marine Craft
 * Hydrodynamics and Motion Control, 2nd ed., section 12.4). Not thread-safe.
 */
final class Drift {
  private static final double[] CHANGE = {0.1, 0.1, 0.02}; // of each component in one second
  private static final double[] MAX_VARIANCE = {0.25, 0.25, 0.25};
  private static final double SIGMA_MPS = 0.25; // of the sideways velocity, over one second
  private static final double STEADY_RADPS = 0.3; // in faster turns the slip is not steady
  private static final double SLOWEST_MPS = 0.3; // through the water
  private static final double MAX_RAD = Math.toRadians(50.0);

  private final double[] drift = new double[3]; // north, east [m/s], slip per turn rate [m]
  private final double[][] variance = new double[3][3];

  Drift() {
    for (int i = 0; i < drift.length; i++) {
      variance[i][i] = MAX_VARIANCE[i];
    }
  }

  /**
   * Learns from one step, by a Kalman filter.
   *
   * @param headingRad clockwise from north
   * @param asideMps velocity over ground to the right
   * @param turnRadps turn rate, positive to the right
   */
  void step(double headingRad, double asideMps, double turnRadps, double stepS) {
    if (stepS <= 0.0) {
      return;
    }
    double[] seen = {-Math.sin(headingRad), Math.cos(headingRad), turnRadps};
    double turn = turnRadps / STEADY_RADPS;
    double total = SIGMA_MPS * SIGMA_MPS * (1.0 + turn * turn) / stepS;
    double error = asideMps;
    double[] shares = new double[3];
    for (int i = 0; i < 3; i++) {
      variance[i][i] = Math.min(MAX_VARIANCE[i], variance[i][i] + CHANGE[i] * CHANGE[i] * stepS);
      for (int j = 0; j < 3; j++) {
        shares[i] += variance[i][j] * seen[j];
      }
      error -= seen[i] * drift[i];
      total += seen[i] * shares[i];
    }
    for (int i = 0; i < 3; i++) {
      drift[i] += shares[i] / total * error;
      for (int j = 0; j < 3; j++) {
        variance[i][j] -= shares[i] * shares[j] / total;
      }
    }
  }

  /**
   * Angle by which the bow must be to the right of a wanted course [rad].
   *
   * @param courseRad over ground, clockwise from north
   * @param aheadMps velocity over ground along the bow
   */
  double crabRad(double courseRad, double aheadMps) {
    double right = drift[1] * Math.cos(courseRad) - drift[0] * Math.sin(courseRad);
    double ahead = drift[0] * Math.cos(courseRad) + drift[1] * Math.sin(courseRad);
    double through = Math.max(SLOWEST_MPS, aheadMps - ahead);
    double angle = -Math.asin(Math.max(-1.0, Math.min(1.0, right / through)));
    return Math.max(-MAX_RAD, Math.min(MAX_RAD, angle));
  }
}
