package org.u2sa.service.motion;

/**
 * Estimates the {@link Drift} of a vehicle without lateral thrust from its sideways velocity on
 * different headings, separately from the slip of its hull in turns (Fossen, Handbook of Marine
 * Craft Hydrodynamics and Motion Control, 2nd ed., section 12.4). Not thread-safe.
 */
public final class DriftFilter {
  private static final double[] CHANGE = {0.1, 0.1, 0.02}; // of each component in one second
  private static final double[] MAX_VARIANCE = {0.25, 0.25, 0.25};
  private static final double SIGMA_MPS = 0.25; // of the sideways velocity, over one second
  private static final double STEADY_RADPS = 0.3; // at higher turn rates the slip is not steady

  private final double[] drift = new double[3]; // north, east [m/s], slip per turn rate [m]
  private final double[][] variance = new double[3][3];

  public DriftFilter() {
    for (int i = 0; i < drift.length; i++) {
      variance[i][i] = MAX_VARIANCE[i];
    }
  }

  /**
   * Updates the estimate with one step (Kalman filter).
   *
   * @param headingRad clockwise from north
   * @param asideMps velocity over ground to the right
   * @param turnRadps turn rate, positive to the right
   */
  public void step(double headingRad, double asideMps, double turnRadps, double stepS) {
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

  /** Current estimate. */
  public Drift drift() {
    return new Drift(drift[0], drift[1]);
  }
}
