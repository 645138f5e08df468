package org.u2sa.estimation.delay;

import org.u2sa.estimation.rotation.Quaternions;

/**
 * A vehicle's motion from a late measurement until now: north, east, down, with the accelerometers'
 * estimated bias taken from the {@link InertialPath}.
 */
public final class MotionSince {
  /** Change of the velocity [m/s]. */
  public final double[] change = new double[3];

  /** Its derivative with respect to the delay, which is the acceleration then [m/s²]. */
  public final double[] changeSlope = new double[3];

  /** Way beyond that of the present velocity [m]. */
  public final double[] way = new double[3];

  /** Its derivative with respect to the delay [m/s]. */
  public final double[] waySlope = new double[3];

  /** From the axes of the vehicle to north, east, down. */
  public final double[] r = new double[9];

  private final double[] now = new double[6];
  private final double[] early = new double[6];
  private final double[] late = new double[6];

  /**
   * Computes the motion.
   *
   * @param x nominal state
   * @param q index of the attitude in it
   * @param bias index of the accelerometers' bias in it
   * @param lateS delay of the measurement [s]
   * @param sigmaS its standard deviation, over which the slopes are averaged
   * @return false if the path does not reach back so far
   */
  public boolean look(double[] path, double[] x, int q, int bias, double lateS, double sigmaS) {
    double from = Math.min(MotionDelay.MAX_S, lateS + sigmaS);
    double to = Math.max(0.0, lateS - sigmaS);
    boolean isKnown =
        InertialPath.since(path, lateS, now)
            && InertialPath.since(path, from, early)
            && InertialPath.since(path, to, late);
    Quaternions.matrix(x, q, r);
    for (int i = 0; isKnown && i < 3; i++) {
      double b = r[3 * i] * x[bias] + r[3 * i + 1] * x[bias + 1] + r[3 * i + 2] * x[bias + 2];
      change[i] = now[i] - lateS * b;
      way[i] = now[3 + i] + 0.5 * lateS * lateS * b;
      changeSlope[i] = (early[i] - late[i]) / (from - to) - b;
      waySlope[i] = (early[3 + i] - late[3 + i]) / (from - to) + lateS * b;
    }
    return isKnown;
  }
}
