package org.u2sa.estimation.fusion;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.MotionHeading;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Recovers from a tilt that was learned from a wrong position or speed, or that gyroscopes whose
 * bias has changed turn away. An inertial velocity drifts with the tilt's error, so correcting only
 * the velocity does not help: until the tilt and the biases may change again, the velocity runs
 * away from every other source.
 */
final class InertialContradiction {
  private static final double SINCE_S = 0.5; // minimum duration of a contradiction
  private static final int MIN_SOURCES = 2; // one may be wrong itself
  private static final int MIN_STREAK = 3;
  private static final double MISLED_RAD = 0.3;

  private final FilterTuning tuning;
  private final SourceTrust trust;

  InertialContradiction(FilterTuning tuning, SourceTrust trust) {
    this.tuning = tuning;
    this.trust = trust;
  }

  /**
   * Whether several sources of position or speed, or one and the wheels' grip, have begun to
   * contradict an inertial estimate within the reset time. One that has contradicted it for longer
   * is itself wrong.
   */
  boolean isShown(FilterState s) {
    boolean slides = s.slidingMicros > 0 && isRecent(s, s.slidingMicros);
    int contradicting = slides && tuning.domain() == MotionDomain.GROUND ? 1 : 0;
    for (int source = 0; s.isStrapdown && source < trust.sources(); source++) {
      contradicting += contradicts(s, source) ? 1 : 0;
    }
    return contradicting >= MIN_SOURCES;
  }

  private boolean contradicts(FilterState s, int source) {
    for (int q = 0; q < SensedQuantity.count(); q++) {
      SensedQuantity quantity = SensedQuantity.at(q);
      if (isOfMotion(quantity) && contradicts(s, source, quantity)) {
        return true;
      }
    }
    return false;
  }

  private boolean contradicts(FilterState s, int source, SensedQuantity quantity) {
    if (!trust.isKnown(source, quantity)) {
      return false;
    }
    int at = trust.of(s, source, quantity);
    boolean isLeftOut = quantity.isPlace() && s.trust[at + SourceTrust.IS_BIASED] != 0.0;
    return !isLeftOut
        && isRecent(s, s.trust[at + SourceTrust.STREAK_SINCE])
        && s.trust[at + SourceTrust.STREAK] >= MIN_STREAK;
  }

  /**
   * Whether an aircraft's measured roll and pitch, and another source, have begun to contradict
   * what its gyroscopes say within the reset time: their bias has changed.
   */
  boolean isOfGyroscopes(FilterState s) {
    boolean hasTilt = false;
    int contradicting = 0;
    boolean isPossible = s.isInertial && tuning.domain() != MotionDomain.GROUND;
    for (int source = 0; isPossible && source < trust.sources(); source++) {
      boolean ofTilt = contradicts(s, source, SensedQuantity.TILT);
      hasTilt |= ofTilt;
      boolean others = contradicts(s, source, SensedQuantity.HEADING) || contradicts(s, source);
      contradicting += ofTilt || others ? 1 : 0;
    }
    return hasTilt && contradicting >= MIN_SOURCES;
  }

  /** Lets attitude and biases be learnt again, and ends what contradicted them. */
  void reopenGyroscopes(FilterState s) {
    reopen(s);
    s.isolate(FilterState.ATTITUDE + 2, MISLED_RAD * MISLED_RAD);
    for (int source = 0; source < trust.sources(); source++) {
      for (SensedQuantity quantity : List.of(SensedQuantity.TILT, SensedQuantity.HEADING)) {
        if (trust.isKnown(source, quantity)) {
          s.trust[trust.of(s, source, quantity) + SourceTrust.STREAK] = 0.0;
        }
      }
    }
    admit(s);
  }

  /**
   * Whether a position or speed is rejected again and again while its receiver's velocities show
   * that the heading is wrong.
   */
  boolean isOfHeading(FilterState s, SensedQuantity quantity, int at) {
    return isOfMotion(quantity)
        && s.trust[at + SourceTrust.STREAK] >= MIN_STREAK
        && MotionHeading.refutes(s.motion, 0.0);
  }

  /** Turns the heading to that of the motion, and lets what it misled be learnt again. */
  void turnHeading(FilterState s) {
    double[] r = new double[9];
    Quaternions.matrix(s.x, FilterState.Q, r);
    double sigma = MotionHeading.sigmaRad(s.motion);
    double psi = Quaternions.psi(r) + MotionHeading.errorRad(s.motion);
    reopenMotion(s);
    Alignment.heading(s, psi, sigma * sigma);
    MotionHeading.followed(s.motion);
    admit(s);
  }

  private boolean isRecent(FilterState s, double sinceMicros) {
    double seconds = (s.micros - sinceMicros) * 1e-6;
    return seconds >= SINCE_S && seconds <= tuning.resetAfterS();
  }

  static boolean isOfMotion(SensedQuantity quantity) {
    return quantity.isPlace() || SpeedDoubt.isOfSpeed(quantity);
  }

  /**
   * Returns velocity, tilt, biases, wheel scale and delays to their initial uncertainty. Vehicles
   * other than aircraft are levelled again by their specific force, which does not show an
   * aircraft's bank.
   */
  void reopen(FilterState s) {
    reopenMotion(s);
    for (int i = 0; i < 3; i++) {
      Alignment.gyroBias(s, i);
    }
  }

  private void reopenMotion(FilterState s) {
    double speed = tuning.domain().speedSigmaMps;
    for (int i = 0; i < 3; i++) {
      s.isolate(FilterState.VELOCITY + i, speed * speed);
      s.x[FilterState.BF + i] = 0.0;
      s.isolate(FilterState.FORCE_BIAS + i, tuning.forceBiasSigma() * tuning.forceBiasSigma());
      s.x[FilterState.LEVELLING + i] = 0.0;
    }
    s.reopenedMicros = s.micros;
    Alignment.wheelScale(s, tuning);
    DelayErrors.reopen(s, tuning);
    s.x[FilterState.LEVELLED] = 0.0;
    s.hasTilt = tuning.domain() == MotionDomain.AIR;
    s.isStrapdown = s.hasTilt;
    for (int i = 0; i < 2 && s.hasTilt; i++) {
      s.isolate(FilterState.ATTITUDE + i, MISLED_RAD * MISLED_RAD);
    }
  }

  /**
   * Admits the positions that contradict the estimate, and ends all contradictions. Speeds that did
   * not contradict it, such as those of an encoder with a wrong scale, are doubted.
   */
  void admit(FilterState s) {
    List<Integer> doubted = new ArrayList<>();
    for (int source = 0; source < trust.sources(); source++) {
      for (int q = 0; q < SensedQuantity.count() && !contradicts(s, source); q++) {
        SensedQuantity quantity = SensedQuantity.at(q);
        if (SpeedDoubt.isOfSpeed(quantity) && trust.isKnown(source, quantity)) {
          int at = trust.of(s, source, quantity);
          boolean isUsed = s.micros - s.trust[at + SourceTrust.LAST_USED] < SINCE_S * 1e6;
          doubted.addAll(isUsed ? List.of(at) : List.of());
        }
      }
    }
    for (int source = 0; source < trust.sources(); source++) {
      for (int q = 0; q < SensedQuantity.count(); q++) {
        SensedQuantity quantity = SensedQuantity.at(q);
        if (isOfMotion(quantity) && trust.isKnown(source, quantity)) {
          int at = trust.of(s, source, quantity);
          for (int i = 0; i < 2 && quantity.isPlace(); i++) {
            double apart = s.trust[at + SourceTrust.STREAK_NEWEST + i];
            s.p.data[(FilterState.POSITION + i) * (FilterState.N + 1)] +=
                s.trust[at + SourceTrust.STREAK] > 0.0 ? apart * apart : 0.0;
          }
          s.trust[at + SourceTrust.STREAK] = 0.0;
          s.trust[at + SourceTrust.IS_BIASED] = 0.0;
        }
      }
    }
    double mps = Math.hypot(s.x[FilterState.V], s.x[FilterState.V + 1]);
    doubted.forEach(at -> SpeedDoubt.accuse(s, at, mps));
    s.slidingMicros = 0;
    s.resets++;
  }
}
