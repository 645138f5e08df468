package org.u2sa.planning.curve;

/**
 * Shortest path of a vehicle that can reverse and has a minimum turn radius (Reeds, Shepp: Optimal
 * Paths for a Car That Goes Both Forwards and Backwards, Pacific Journal of Mathematics 145, 1990,
 * section 8).
 *
 * <p>Each family of the paper is tried as-is, time-reversed, mirrored, and both; asymmetric ones
 * also from end to start.
 */
public final class ReedsShepp {
  private static final double HALF = Math.PI / 2.0;
  private static final double ROUNDING = 1.0e-9;

  private static final int L = -1;
  private static final int S = 0;
  private static final int R = 1;

  private double best = Double.POSITIVE_INFINITY;
  private double[] lengths = {};
  private int[] senses = {};

  private ReedsShepp() {}

  public static Curve shortest(Pose from, Pose to, double radiusM) {
    return search(from, to, radiusM, 0.0);
  }

  /**
   * Length of the shortest path between two poses [m]; once a path of at most {@code enoughM} is
   * found, its length is returned without searching further.
   */
  public static double lengthM(Pose from, Pose to, double radiusM, double enoughM) {
    return search(from, to, radiusM, enoughM).lengthM();
  }

  private static Curve search(Pose from, Pose to, double radiusM, double enoughM) {
    Pose rel = from.relative(to);
    // The paper's y is to the left, its angles are counter-clockwise.
    double x = rel.northM() / radiusM;
    double y = -rel.eastM() / radiusM;
    double phi = -rel.headingRad();
    double enough = enoughM / radiusM - ROUNDING;
    ReedsShepp search = new ReedsShepp();
    for (int variant = 0; variant < 4 && search.best > enough; variant++) {
      int time = (variant & 1) == 0 ? 1 : -1;
      int mirror = (variant & 2) == 0 ? 1 : -1;
      search.families(time * x, mirror * y, time * mirror * phi, time, mirror, false);
      if (search.best > enough) {
        double backX = x * Math.cos(phi) + y * Math.sin(phi);
        double backY = x * Math.sin(phi) - y * Math.cos(phi);
        search.families(time * backX, mirror * backY, time * mirror * phi, time, mirror, true);
      }
    }
    return Curve.of(radiusM, search.lengths, search.senses);
  }

  private void families(double x, double y, double phi, int time, int mirror, boolean reversed) {
    if (!reversed) {
      curveStraightCurve(x, y, phi, time, mirror);
      fourCurves(x, y, phi, time, mirror);
      curvesAroundStraight(x, y, phi, time, mirror);
    }
    threeCurves(x, y, phi, time, mirror, reversed);
    straightBetweenFour(x, y, phi, time, mirror, reversed);
  }

  /** C S C: eqs. 8.1 and 8.2. */
  private void curveStraightCurve(double x, double y, double phi, int time, int mirror) {
    double xi = x - Math.sin(phi);
    double eta = y - 1.0 + Math.cos(phi);
    double u = Math.hypot(xi, eta);
    double t = Math.atan2(eta, xi);
    take(time, mirror, false, new int[] {L, S, L}, t, u, Pose.wrapped(phi - t)); // 8.1
    double xi2 = x + Math.sin(phi);
    double eta2 = y - 1.0 - Math.cos(phi);
    double u1 = xi2 * xi2 + eta2 * eta2;
    if (u1 >= 4.0) {
      double u2 = Math.sqrt(u1 - 4.0);
      double t2 = Pose.wrapped(Math.atan2(eta2, xi2) + Math.atan2(2.0, u2));
      take(time, mirror, false, new int[] {L, S, R}, t2, u2, Pose.wrapped(t2 - phi)); // 8.2
    }
  }

  /** C | C | C and C | C C: eqs. 8.3 and 8.4. */
  private void threeCurves(double x, double y, double phi, int time, int mirror, boolean reversed) {
    double xi = x - Math.sin(phi);
    double eta = y - 1.0 + Math.cos(phi);
    double u1 = Math.hypot(xi, eta);
    if (u1 > 4.0) {
      return;
    }
    double theta = Math.atan2(eta, xi);
    double u = -2.0 * Math.asin(0.25 * u1);
    double t = Pose.wrapped(theta + 0.5 * u + Math.PI);
    double v = Pose.wrapped(phi - t + u);
    take(time, mirror, reversed, new int[] {L, R, L}, t, u, v);
  }

  /** C C_u | C_u C and C | C_u C_u | C: eqs. 8.7 and 8.8. */
  private void fourCurves(double x, double y, double phi, int time, int mirror) {
    double xi = x + Math.sin(phi);
    double eta = y - 1.0 - Math.cos(phi);
    double rho = 0.25 * (2.0 + Math.hypot(xi, eta));
    if (rho <= 1.0) { // 8.7
      double u = Math.acos(rho);
      double[] tv = tauOmega(u, -u, xi, eta, phi);
      take(time, mirror, false, new int[] {L, R, L, R}, tv[0], u, -u, tv[1]);
    }
    double rho2 = (20.0 - xi * xi - eta * eta) / 16.0;
    if (rho2 >= 0.0 && rho2 <= 1.0) { // 8.8
      double u = -Math.acos(rho2);
      if (u >= -HALF) {
        double[] tv = tauOmega(u, u, xi, eta, phi);
        take(time, mirror, false, new int[] {L, R, L, R}, tv[0], u, u, tv[1]);
      }
    }
  }

  /** C | C_π/2 S C: eqs. 8.9 and 8.10. */
  private void straightBetweenFour(
      double x, double y, double phi, int time, int mirror, boolean reversed) {
    double xi = x - Math.sin(phi);
    double eta = y - 1.0 + Math.cos(phi);
    double rho = Math.hypot(xi, eta);
    double theta = Math.atan2(eta, xi);
    if (rho >= 2.0) { // 8.9
      double r = Math.sqrt(rho * rho - 4.0);
      double t = Pose.wrapped(theta + Math.atan2(r, -2.0));
      double v = Pose.wrapped(phi - HALF - t);
      take(time, mirror, reversed, new int[] {L, R, S, L}, t, -HALF, 2.0 - r, v);
    }
    double xi2 = x + Math.sin(phi);
    double eta2 = y - 1.0 - Math.cos(phi);
    double rho2 = Math.hypot(-eta2, xi2);
    if (rho2 >= 2.0) { // 8.10
      double t = Math.atan2(xi2, -eta2);
      double u = 2.0 - rho2;
      take(
          time,
          mirror,
          reversed,
          new int[] {L, R, S, R},
          t,
          -HALF,
          u,
          Pose.wrapped(t + HALF - phi));
    }
  }

  /** C | C_π/2 S C_π/2 | C: eq. 8.11. */
  private void curvesAroundStraight(double x, double y, double phi, int time, int mirror) {
    double xi = x + Math.sin(phi);
    double eta = y - 1.0 - Math.cos(phi);
    double rho = Math.hypot(xi, eta);
    if (rho < 2.0) {
      return;
    }
    double u = 4.0 - Math.sqrt(rho * rho - 4.0);
    if (u > 0.0) {
      return;
    }
    double t = Pose.wrapped(Math.atan2((4.0 - u) * xi - 2.0 * eta, -2.0 * xi + (u - 4.0) * eta));
    take(time, mirror, false, new int[] {L, R, S, L, R}, t, -HALF, u, -HALF, Pose.wrapped(t - phi));
  }

  /** The angles before and after two equal ones (eq. 8.6). */
  private static double[] tauOmega(double u, double v, double xi, double eta, double phi) {
    double delta = Pose.wrapped(u - v);
    double a = Math.sin(u) - Math.sin(delta);
    double b = Math.cos(u) - Math.cos(delta) - 1.0;
    double t1 = Math.atan2(eta * a - xi * b, xi * a + eta * b);
    double t2 = 2.0 * (Math.cos(delta) - Math.cos(v) - Math.cos(u)) + 3.0;
    double tau = t2 < 0.0 ? Pose.wrapped(t1 + Math.PI) : Pose.wrapped(t1);
    return new double[] {tau, Pose.wrapped(tau - u + v - phi)};
  }

  /** Stores a candidate if it is the shortest so far. */
  private void take(int time, int mirror, boolean reversed, int[] word, double... found) {
    double sum = 0.0;
    for (double length : found) {
      sum += Math.abs(length);
    }
    if (sum >= best - ROUNDING) {
      return;
    }
    best = sum;
    lengths = new double[found.length];
    senses = new int[found.length];
    for (int i = 0; i < found.length; i++) {
      int at = reversed ? found.length - 1 - i : i;
      lengths[at] = time * found[i];
      senses[at] = mirror * word[i];
    }
  }
}
