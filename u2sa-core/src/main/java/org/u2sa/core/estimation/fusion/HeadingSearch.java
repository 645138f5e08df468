package org.u2sa.core.estimation.fusion;

/**
 * Finds the heading where nothing measures it. Speed and turn rate of the wheels say which way the
 * vehicle went by its own axes, positions say which way it went on earth: the angle between the two
 * is the heading, forward or in reverse. What it went by its own axes is added up along the nominal
 * heading, whose start is arbitrary until the heading is known.
 */
final class HeadingSearch {
  private static final int FORWARD = 0; // newest speed along the vehicle [m/s]
  private static final int FORWARD_MICROS = 1;
  private static final int WAY = 2; // since the anchor, along the nominal heading: north, east [m]
  private static final int ANCHOR = 4; // north, east [m]
  private static final int ANCHOR_VARIANCE = 6; // m²; 0: there is no anchor
  private static final int TURN_VARIANCE = 7; // of turns since the anchor that nobody measured
  static final int NUMBERS = 8;

  private static final double FRESH_S = 1.0;
  private static final double MAX_SIGMA_RAD = 0.3;
  private static final double UNLIKELY =
      3.0; // standard deviations of a way that is not the wheels'
  private static final double SLIP = 0.1; // share of the way
  private static final double UNMEASURED = 0.01; // rad² per second of turns that nobody measures

  private HeadingSearch() {}

  private static double psi(FilterState s) {
    double[] r = new double[9];
    Quaternions.matrix(s.x, FilterState.Q, r);
    return Quaternions.psi(r);
  }

  /** Takes note of a speed along the vehicle. */
  static void speed(FilterState s, Measurement m) {
    double[] h = s.search;
    double forward = m.value(SensedQuantity.BODY_VELOCITY, 0);
    double seconds = (s.micros - h[FORWARD_MICROS]) * 1e-6;
    if (!s.hasHeading && seconds < FRESH_S) {
      double psi = psi(s);
      double way = seconds * 0.5 * (h[FORWARD] + forward);
      h[WAY] += way * StrictMath.cos(psi);
      h[WAY + 1] += way * StrictMath.sin(psi);
      boolean isMeasured = s.isInertial || MotionInput.drivesTurn(s);
      h[TURN_VARIANCE] += isMeasured ? 0.0 : UNMEASURED * seconds;
    } else {
      h[ANCHOR_VARIANCE] = 0.0;
    }
    h[FORWARD] = forward;
    h[FORWARD_MICROS] = s.micros;
  }

  /** Newest speed along the vehicle [m/s]; NaN if none is fresh. */
  static double forwardMps(FilterState s) {
    boolean isFresh =
        s.search[FORWARD_MICROS] > 0.0 && (s.micros - s.search[FORWARD_MICROS]) * 1e-6 < FRESH_S;
    return isFresh ? s.search[FORWARD] : Double.NaN;
  }

  /**
   * Takes note of a position, where the heading is not known, and sets the heading if that tells
   * it.
   *
   * @param north of the position [m]
   * @param variance of it, of each axis [m²]
   */
  static void position(FilterState s, double north, double east, double variance) {
    double[] h = s.search;
    if (s.hasHeading || Double.isNaN(forwardMps(s))) {
      return;
    }
    if (h[ANCHOR_VARIANCE] == 0.0) {
      h[ANCHOR] = north;
      h[ANCHOR + 1] = east;
      h[ANCHOR_VARIANCE] = variance;
      h[TURN_VARIANCE] = 0.0;
      h[WAY] = 0.0;
      h[WAY + 1] = 0.0;
      return;
    }
    double dn = north - h[ANCHOR];
    double de = east - h[ANCHOR + 1];
    double wheels = Math.hypot(h[WAY], h[WAY + 1]);
    double across2 = h[ANCHOR_VARIANCE] + variance;
    double sigma = Math.sqrt(across2 / Math.max(1e-6, wheels * wheels) + h[TURN_VARIANCE]);
    if (sigma > MAX_SIGMA_RAD) {
      return;
    }
    double apart = Math.hypot(dn, de) - wheels;
    if (apart * apart > UNLIKELY * UNLIKELY * (across2 + SLIP * SLIP * wheels * wheels)) {
      h[ANCHOR_VARIANCE] = 0.0; // it slipped, or turned unseen: from here anew
      return;
    }
    double turn = StrictMath.atan2(de, dn) - StrictMath.atan2(h[WAY + 1], h[WAY]);
    double of = Math.max(SLIP, sigma);
    Alignment.heading(s, psi(s) + turn, of * of);
  }
}
