package org.u2sa.estimation.fusion;

import java.util.Arrays;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Estimates the heading if no source measures it. Speed and turn rate of the wheels give the
 * displacement in the vehicle's axes, positions give it in earth axes: the angle between the two is
 * the heading, whether driving forward or in reverse. The wheel displacement is integrated along
 * the nominal heading, whose initial value is arbitrary until the heading is known.
 *
 * <p>A fix is z = c + h w + e, as complex numbers (north, i east): h rotates the wheel displacement
 * w by the unknown heading, e is white noise, and c drifts like the receiver's correlated error
 * (multipath lasts for half a minute or more). The model is linear, so a Kalman filter of c and h
 * is exact however uncertain the heading. The split of the claimed variance into white and
 * correlated noise is unknown, so each is assumed to have all of it.
 */
final class HeadingSearch {
  private static final int FORWARD = 0; // newest speed along the vehicle [m/s]
  private static final int FORWARD_MICROS = 1;
  private static final int WAY = 2; // since the first fix, by nominal heading: north, east
  private static final int FIRST = 4; // first fix: north, east [m]
  private static final int FIX_MICROS = 6; // time of the newest fix; 0: none
  private static final int SOURCE = 7;
  private static final int TURN_VARIANCE = 8; // due to unmeasured turns since the first fix
  private static final int C = 9; // relative to the first fix [m]
  private static final int H = 11;
  private static final int CC = 13; // variances per axis of c and h
  private static final int HH = 14;
  private static final int CH = 15; // covariance E(c h*)

  private static final double FRESH_S = 1.0;
  private static final double SILENT_S = 5.0; // after this another source may be used
  private static final double UNKNOWN = 100.0; // variance per axis of h, whose length is 1
  private static final double MAX_SIGMA_RAD = 0.15; // displacement of about ten position sigmas
  private static final double UNLIKELY =
      3.0; // maximum difference of the displacements, in standard deviations
  private static final double SLIP = 0.1; // fraction of the displacement
  private static final double UNMEASURED = 0.01; // rad²/s of unmeasured turns
  private static final double USUAL = 4.0; // NIS above which a fix is down-weighted

  private HeadingSearch() {}

  private static double psi(FilterState s) {
    double[] r = new double[9];
    Quaternions.matrix(s.x, FilterState.Q, r);
    return Quaternions.psi(r);
  }

  /** Discards the fixes; the search restarts with the next fix. */
  static void restart(FilterState s) {
    s.search[FIX_MICROS] = 0.0;
  }

  /** Integrates a forward speed. */
  static void speed(FilterState s, Measurement m) {
    double[] h = s.search;
    double forward = m.value(SensedQuantity.BODY_VELOCITY, 0);
    double seconds = (s.micros - h[FORWARD_MICROS]) * 1e-6;
    if (!s.hasHeading && seconds < FRESH_S) {
      double psi = psi(s);
      double way = seconds * 0.5 * (h[FORWARD] + forward);
      h[WAY] += way * StrictMath.cos(psi);
      h[WAY + 1] += way * StrictMath.sin(psi);
      boolean isMeasured = s.isInertial || s.hasTurnInput();
      h[TURN_VARIANCE] += isMeasured ? 0.0 : UNMEASURED * seconds;
    } else {
      restart(s);
    }
    h[FORWARD] = forward;
    h[FORWARD_MICROS] = s.micros;
  }

  /** Newest forward speed [m/s]; NaN if none is fresh. */
  static double forwardMps(FilterState s) {
    boolean isFresh =
        s.search[FORWARD_MICROS] > 0.0 && (s.micros - s.search[FORWARD_MICROS]) * 1e-6 < FRESH_S;
    return isFresh ? s.search[FORWARD] : Double.NaN;
  }

  /**
   * Processes a position while the heading is unknown, and sets the heading once the positions of
   * this source determine it.
   *
   * @param north north coordinate of the position [m]
   * @param variance variance of the position per axis [m²]
   * @param persistsS correlation time of its error [s]; 0: independent errors
   */
  static void position(
      FilterState s, int source, double north, double east, double variance, double persistsS) {
    double[] h = s.search;
    if (s.hasHeading || Double.isNaN(forwardMps(s))) {
      return;
    }
    double seconds = (s.micros - h[FIX_MICROS]) * 1e-6;
    boolean isLost = h[TURN_VARIANCE] > MAX_SIGMA_RAD * MAX_SIGMA_RAD;
    boolean isOther = source != (int) h[SOURCE];
    if (h[FIX_MICROS] == 0.0 || isLost || isOther && seconds > SILENT_S) {
      Arrays.fill(h, WAY, h.length, 0.0);
      h[FIRST] = north;
      h[FIRST + 1] = east;
      h[FIX_MICROS] = s.micros;
      h[SOURCE] = source;
      h[CC] = variance;
      h[HH] = UNKNOWN;
    } else if (!isOther) {
      h[FIX_MICROS] = s.micros;
      h[CC] += persistsS > 0.0 ? 2.0 * variance * seconds / persistsS : 0.0;
      update(h, north - h[FIRST], east - h[FIRST + 1], variance);
      tell(s);
    }
  }

  /** Updates c and h with a fix. */
  private static void update(double[] h, double north, double east, double fixVariance) {
    double wn = h[WAY];
    double we = h[WAY + 1];
    double dn = north - h[C] - (h[H] * wn - h[H + 1] * we);
    double de = east - h[C + 1] - (h[H] * we + h[H + 1] * wn);
    double cross = h[CH] * wn + h[CH + 1] * we;
    double variance = h[CC] + 2.0 * cross + (wn * wn + we * we) * h[HH] + fixVariance;
    variance = Math.max(variance, (dn * dn + de * de) / USUAL);
    double kcn = (h[CC] + cross) / variance;
    double kce = (h[CH + 1] * wn - h[CH] * we) / variance;
    double khn = (h[CH] + wn * h[HH]) / variance;
    double khe = -(h[CH + 1] + we * h[HH]) / variance;
    h[C] += kcn * dn - kce * de;
    h[C + 1] += kcn * de + kce * dn;
    h[H] += khn * dn - khe * de;
    h[H + 1] += khn * de + khe * dn;
    h[CC] -= (kcn * kcn + kce * kce) * variance;
    h[HH] -= (khn * khn + khe * khe) * variance;
    h[CH] -= (kcn * khn + kce * khe) * variance;
    h[CH + 1] -= (kce * khn - kcn * khe) * variance;
  }

  /** Sets the heading if it is accurate enough. */
  private static void tell(FilterState s) {
    double[] h = s.search;
    double sigma = Math.sqrt(h[HH] + h[TURN_VARIANCE]);
    if (sigma > MAX_SIGMA_RAD) {
      return;
    }
    double apart = Math.hypot(h[H], h[H + 1]) - 1.0;
    if (apart * apart > UNLIKELY * UNLIKELY * (h[HH] + SLIP * SLIP)) {
      restart(s); // slip or an unmeasured turn
      return;
    }
    double of = Math.max(SLIP, sigma);
    Alignment.heading(s, psi(s) + StrictMath.atan2(h[H + 1], h[H]), of * of);
  }
}
