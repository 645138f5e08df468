package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Slip of wheels in turns and on slopes.
 *
 * <p>In a turn, unsteered wheels that are not on one axle slide sideways, and the vehicle turns
 * about a point ahead of or behind the one that is taken as its position, depending on its loads
 * and its ground; wheels that slide do not show its forward speed either (Martínez et al. 2005,
 * IJRR 24(10); Mandow et al. 2007, IROS). Both errors are as constant as the turn. Wheels that are
 * the only measure of the turn, as without gyroscopes, count as rolling until a heading contradicts
 * it.
 *
 * <p>On a slope, a tyre passes on the weight along the slope only while it creeps, by the weight's
 * share over the tyre's stiffness of 3 to 10 per unit of load (brush model, Pacejka 2012, section
 * 3.2). Along the way, the creep changes the wheel scale; across it, the vehicle does not move
 * where its wheels point. Both last as long as the slope.
 */
final class WheelSlip {
  private static final double CREEP = 0.3; // of the speed, per sine of the slope, 1 sigma
  private static final double LEVEL = 0.05; // sine of a slope that counts as level
  private static final double LEARNS_TILT_S = 8.0; // until then, a tilt may be a wrong speed
  private static final double SCALE_LASTS_S = 10.0;
  private static final double LASTS_S = 1.0; // correlation time across the way and in turns
  private static final double PIVOT_M = 0.2; // centre of the turn ahead or behind, 1 sigma
  private static final double PIVOT_ASIDE_M = 0.05; // the same to the side, from sliding wheels
  private static final double ARM_M =
      2.5; // creep per turn rate: skidding uses up most of the grip of wheels 0.4 m out

  private final FilterTuning tuning;
  private final double[] r = new double[9];

  WheelSlip(FilterTuning tuning) {
    this.tuning = tuning;
  }

  private boolean isUsed(FilterState s) {
    boolean isTiltKnown = s.hasTilt && (s.micros - s.startedMicros) * 1e-6 > LEARNS_TILT_S;
    return tuning.domain() == MotionDomain.GROUND && isTiltKnown;
  }

  /**
   * Widens the wheel scale where the slope along the way has changed, and slowly on a slope: what
   * inertial sensors taught about it in the first seconds is worth little a minute later.
   */
  void alongTheWay(FilterState s, double intervalS) {
    if (!isUsed(s) || s.variance(FilterState.SCALE) == 0.0) {
      return;
    }
    Quaternions.matrix(s.x, FilterState.Q, r);
    double change = -r[6] - s.x[FilterState.SLOPE];
    double share2 = Math.abs(r[6]) < LEVEL ? 0.0 : r[6] * r[6] * intervalS / SCALE_LASTS_S;
    if (Math.abs(change) > LEVEL / 2.0) {
      s.x[FilterState.SLOPE] += change;
      share2 += change * change;
    }
    s.p.data[FilterState.SCALE * (FilterState.N + 1)] += CREEP * CREEP * share2;
  }

  /**
   * Variance to add to that of a sideways speed of zero [m²/s²]; 0 on level ground without a turn.
   *
   * @param intervalS time between such measurements [s]
   */
  double acrossVariance(FilterState s, double intervalS) {
    return acrossSlopeVariance(s, intervalS) + turnVariance(s, PIVOT_M, intervalS);
  }

  private double acrossSlopeVariance(FilterState s, double intervalS) {
    if (!isUsed(s)) {
      return 0.0;
    }
    Quaternions.matrix(s.x, FilterState.Q, r);
    double speed = Math.hypot(s.x[FilterState.V], s.x[FilterState.V + 1]);
    return slopeVariance(r[7], speed + skidMps(s), intervalS);
  }

  /** Speed at which wheels skid in a turn: unlike rolling ones, they slide in any direction. */
  private static double skidMps(FilterState s) {
    return ARM_M * Math.abs(s.x[FilterState.W + 2]);
  }

  private static double slopeVariance(double slope, double speedMps, double intervalS) {
    return Math.abs(slope) < LEVEL ? 0.0 : variance(CREEP * slope * speedMps, intervalS);
  }

  /** Variance in a turn about a point that is uncertain by so much. */
  private double turnVariance(FilterState s, double pivotM, double intervalS) {
    boolean isSeen = s.isInertial || s.slipsInTurns;
    boolean isUsed = isSeen && tuning.domain() == MotionDomain.GROUND;
    return isUsed ? variance(pivotM * s.x[FilterState.W + 2], intervalS) : 0.0;
  }

  /** Variance of independent errors that are worth as much as those that last. */
  private static double variance(double sigma, double intervalS) {
    return sigma * sigma * (1.0 + 2.0 * LASTS_S / Math.max(1e-3, intervalS));
  }

  /** Whether a speed along the vehicle's axes is that of wheels: its sideways speed is assumed. */
  private static boolean isOfWheels(Measurement m) {
    SensedQuantity velocity = SensedQuantity.BODY_VELOCITY;
    return !m.has(velocity, 1) || m.value(velocity, 1) == 0.0;
  }

  /** Variance in a turn to add to that of a forward speed [m²/s²]. */
  double turnAlongVariance(FilterState s, Measurement m, double intervalS) {
    return isOfWheels(m) ? turnVariance(s, PIVOT_ASIDE_M, intervalS) : 0.0;
  }

  /** Variance in a turn to add to that of a sideways speed [m²/s²]. */
  double turnAcrossVariance(FilterState s, Measurement m, double intervalS) {
    return isOfWheels(m) ? turnVariance(s, PIVOT_M, intervalS) : 0.0;
  }

  /** Adds variances to a measured speed along the vehicle's axes. */
  void widen(FilterState s, Measurement m, Linearization linear, double intervalS) {
    double across = acrossSlopeVariance(s, intervalS) + turnAcrossVariance(s, m, intervalS);
    int row = 0;
    if (m.has(SensedQuantity.BODY_VELOCITY, 0)) {
      double slope = isUsed(s) ? slopeVariance(r[6], skidMps(s), intervalS) : 0.0;
      linear.variance[row++] += slope + turnAlongVariance(s, m, intervalS);
    }
    if (m.has(SensedQuantity.BODY_VELOCITY, 1)) {
      linear.variance[row] += across;
    }
  }
}
