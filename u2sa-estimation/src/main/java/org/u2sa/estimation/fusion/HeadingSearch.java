package org.u2sa.estimation.fusion;

import java.util.Arrays;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;
import org.u2sa.estimation.rotation.TurnedVectors;

/**
 * Estimates the heading if no source measures it. Speed and turn rate of the wheels give the
 * displacement in the vehicle's axes, positions give it in earth axes: the angle between the two is
 * the heading, whether driving forward or in reverse. The wheel displacement is integrated along
 * the nominal heading, whose initial value is arbitrary until the heading is known.
 *
 * <p>The fixes are {@link TurnedVectors} of the wheel displacements, rotated by the unknown
 * heading. Their offset drifts like the receiver's correlated error (multipath lasts for half a
 * minute or more). The split of the claimed variance into white and correlated noise is unknown, so
 * each is assumed to have all of it.
 */
final class HeadingSearch {
  private static final int FORWARD = 0; // newest speed along the vehicle [m/s]
  private static final int FORWARD_MICROS = 1;
  private static final int WAY = 2; // since the first fix, by nominal heading: north, east
  private static final int FIRST = 4; // first fix: north, east [m]
  private static final int FIX_MICROS = 6; // time of the newest fix; 0: none
  private static final int SOURCE = 7;
  private static final int TURN_VARIANCE = 8; // due to unmeasured turns since the first fix
  private static final int FIT = 9; // relative to the first fix [m]

  /** Numbers of the search. */
  static final int SIZE = FIT + TurnedVectors.SIZE;

  private static final double FRESH_S = 1.0;
  private static final double SILENT_S = 5.0; // after this another source may be used
  private static final double MAX_SIGMA_RAD = 0.15; // displacement of about ten position sigmas
  private static final double UNLIKELY =
      3.0; // maximum difference of the displacements, in standard deviations
  private static final double SLIP = 0.1; // fraction of the displacement
  private static final double UNMEASURED = 0.01; // rad²/s of unmeasured turns

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
      TurnedVectors.begin(h, FIT, 0.0, 0.0, variance);
    } else if (!isOther) {
      h[FIX_MICROS] = s.micros;
      double drift = persistsS > 0.0 ? 2.0 * variance * seconds / persistsS : 0.0;
      TurnedVectors.wander(h, FIT, drift, 0.0);
      double n = north - h[FIRST];
      TurnedVectors.update(h, FIT, h[WAY], h[WAY + 1], n, east - h[FIRST + 1], variance);
      tell(s);
    }
  }

  /** Sets the heading if it is accurate enough. */
  private static void tell(FilterState s) {
    double[] h = s.search;
    double sigma = Math.sqrt(TurnedVectors.variance(h, FIT) + h[TURN_VARIANCE]);
    if (sigma > MAX_SIGMA_RAD) {
      return;
    }
    double apart = TurnedVectors.length(h, FIT) - 1.0;
    double expected = TurnedVectors.variance(h, FIT) + SLIP * SLIP;
    if (apart * apart > UNLIKELY * UNLIKELY * expected) {
      restart(s); // slip or an unmeasured turn
      return;
    }
    double of = Math.max(SLIP, sigma);
    Alignment.heading(s, psi(s) + TurnedVectors.angle(h, FIT), of * of);
  }
}
