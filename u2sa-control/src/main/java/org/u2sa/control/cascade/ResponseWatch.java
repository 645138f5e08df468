package org.u2sa.control.cascade;

import java.util.List;
import java.util.Optional;
import org.u2sa.control.allocation.Allocator;
import org.u2sa.control.allocation.DegreeOfFreedom;

/**
 * Detects an actuator that does not respond, or too weakly, from the vehicle's motion: the residual
 * wrench suddenly matches the wrench that actuator should give. The residual is the commanded
 * wrench minus mass times acceleration minus its long-term mean (drag, current, weight).
 *
 * <p>Detects one fault at a time; a disturbance is mistaken for a fault only if it matches one
 * actuator in all controlled axes. Two actuators with the same effect cannot be distinguished, so
 * neither is reported. For faults see Johansen &amp; Fossen 2013, section 4; the residual is that
 * of a disturbance observer. Not thread-safe.
 */
final class ResponseWatch {
  private static final double FILTER_S = 0.5; // filter of forces and of the derivative of velocity
  private static final double LONG_S = 15.0; // time constant of the long-term mean
  private static final double MEMORY_S = 1.5;
  private static final double SETTLES_S = 12.0; // settling time after actuators change
  private static final double SURE_S = 1.0;
  private static final double MIN_LOSS = 0.25; // smaller losses may be due to wrong masses
  private static final double ALL_LOST = 0.6; // the long-term mean hides the rest
  private static final double MAX_LOSS = 1.5;
  private static final double MIN_FIT = 0.85;
  private static final double CLEARLY = 0.1; // margin over the next best match
  private static final double MIN_EFFECT = 0.01; // mean share of the actuators' maximum

  private final double[] force = new double[DegreeOfFreedom.COUNT];
  private final double[] velocity = new double[DegreeOfFreedom.COUNT];
  private final double[] usual = new double[DegreeOfFreedom.COUNT];
  private double[][] effect = {}; // [actuator][axis], filtered
  private double[] common = {}; // Σ r · φ
  private double[] own = {}; // Σ φ · φ
  private double missing; // Σ r · r
  private double sinceS;
  private double sureS;
  private int suspect = -1;

  /**
   * Detected fault.
   *
   * @param left remaining fraction of the actuator's effect, 0…1; 0 if it does not respond
   */
  record Finding(String actuator, double left) {}

  /** Restarts after the actuators changed or the vehicle was at rest. */
  void restart() {
    sinceS = 0.0;
  }

  /**
   * Processes one step.
   *
   * @param allocator allocator after this step's allocation
   * @param measured velocities [m/s] and rates [rad/s], by axis
   * @param masses [kg, kg m²], by axis
   * @return an actuator that responds weakly or not at all, or empty
   */
  Optional<Finding> step(
      Allocator allocator,
      List<DegreeOfFreedom> controlled,
      double[] measured,
      double[] masses,
      double stepS) {
    int count = allocator.effectors().size();
    if (sinceS == 0.0 || effect.length != count) {
      begin(allocator, measured, count);
    }
    sinceS += stepS;
    double share = stepS / (FILTER_S + stepS);
    double forget = Math.exp(-stepS / MEMORY_S);
    missing *= forget;
    for (int i = 0; i < count; i++) {
      common[i] *= forget;
      own[i] *= forget;
    }
    for (DegreeOfFreedom axis : controlled) {
      int j = axis.ordinal();
      force[j] += share * (allocator.attained(axis) - force[j]);
      velocity[j] += share * (measured[j] - velocity[j]);
      double acceleration = (measured[j] - velocity[j]) / FILTER_S;
      double all = force[j] - masses[j] * acceleration;
      if (sinceS < FILTER_S * 4.0) {
        usual[j] = all;
      }
      double scale = Math.max(1e-9, allocator.scale(axis));
      double residual = (all - usual[j]) / scale;
      usual[j] += stepS / LONG_S * (all - usual[j]);
      missing += residual * residual * stepS;
      for (int i = 0; i < count; i++) {
        effect[i][j] += share * (allocator.contribution(i, axis) - effect[i][j]);
        double part = effect[i][j] / scale;
        common[i] += residual * part * stepS;
        own[i] += part * part * stepS;
      }
    }
    return judge(allocator, stepS);
  }

  private void begin(Allocator allocator, double[] measured, int count) {
    effect = new double[count][DegreeOfFreedom.COUNT];
    common = new double[count];
    own = new double[count];
    missing = 0.0;
    sureS = 0.0;
    for (DegreeOfFreedom axis : DegreeOfFreedom.values()) {
      int j = axis.ordinal();
      force[j] = allocator.attained(axis);
      velocity[j] = measured[j];
      for (int i = 0; i < count; i++) {
        effect[i][j] = allocator.contribution(i, axis);
      }
    }
  }

  private Optional<Finding> judge(Allocator allocator, double stepS) {
    int best = -1;
    double bestFit = 0.0;
    double nextFit = 0.0;
    for (int i = 0; i < own.length; i++) {
      boolean isAtWork = own[i] > MIN_EFFECT * MIN_EFFECT * MEMORY_S;
      double fit =
          isAtWork && missing > 0.0 ? common[i] * Math.abs(common[i]) / (own[i] * missing) : 0.0;
      if (fit > bestFit) {
        nextFit = bestFit;
        bestFit = fit;
        best = i;
      } else {
        nextFit = Math.max(nextFit, fit);
      }
    }
    boolean isLikely =
        best >= 0
            && sinceS > SETTLES_S
            && bestFit > MIN_FIT
            && bestFit > nextFit + CLEARLY
            && common[best] > MIN_LOSS * own[best]
            && common[best] < MAX_LOSS * own[best];
    sureS = isLikely && best == suspect ? sureS + stepS : 0.0;
    suspect = isLikely ? best : -1;
    if (sureS < SURE_S) {
      return Optional.empty();
    }
    double loss = common[best] / own[best];
    return Optional.of(
        new Finding(allocator.effectors().get(best).name(), loss < ALL_LOST ? 1.0 - loss : 0.0));
  }
}
