package org.u2sa.control.allocation;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/**
 * Distributes a wanted wrench over effectors: weighted least squares within their limits and rates,
 *
 * <p>min γ Σⱼ (wⱼ (B f − τ)ⱼ / sⱼ)² + Σᵢ cᵢ fᵢ²
 *
 * <p>with wanted wrench τ, shares f, effects B, degree-of-freedom weights w scaled by the maximum s
 * of the healthy effectors, and effector costs c (Johansen &amp; Fossen: Control allocation – a
 * survey, Automatica 49 (2013), section 2.2). Within the limits this is the weighted
 * pseudo-inverse. Allocates no memory per step. Not thread-safe.
 *
 * <p>An axis that has lost its effectors keeps the s of the healthy vehicle, so that its remaining
 * authority is not used at the expense of other axes. The same holds for an axis that effectors
 * reach only through slight misalignment.
 */
public final class Allocator {
  /** Weight of error over effort, γ: relative errors stay below a millionth. */
  private static final double MINOR = 0.05; // fraction of an effect, such as a propeller's torque

  private static final double ERROR_OVER_EFFORT = 1e6;

  /** Share of an effector's force, or moment, below which its effect on an axis is incidental. */
  private static final double INCIDENTAL = 0.05; // about 3 degrees

  private static final int LINEAR_AXES = 3; // the remaining three are angular

  private static final DegreeOfFreedom[] AXES = DegreeOfFreedom.values();

  private final double[] weights;
  private List<Effector> effectors = List.of();
  private List<Effector> sound = List.of();
  private double[] costs = {};
  private double[][] effects = {}; // [effector][axis], at the current speed
  private final double[] scales = new double[DegreeOfFreedom.COUNT];
  private final double[] references = new double[DegreeOfFreedom.COUNT]; // healthy scales
  private double[][] soundReach = {}; // [effector][axis]
  private double[] percents = {};
  private double[] lowest = {};
  private double[] highest = {};
  private double[][] hessian = {};
  private double[] linear = {};
  private BoundedLeastSquares solver = new BoundedLeastSquares(0);
  private final double[] attained = new double[DegreeOfFreedom.COUNT];

  /**
   * @param weights weights of the degrees of freedom in their order, 0 or more; 0 if not
   *     controlled; errors go to lower weights
   */
  public Allocator(double... weights) {
    if (weights.length != DegreeOfFreedom.COUNT
        || Arrays.stream(weights).anyMatch(weight -> !(weight >= 0.0 && weight < 1e6))) {
      throw new IllegalArgumentException(
          "weights " + Arrays.toString(weights) + ": expected six numbers from 0 to 1e6");
    }
    this.weights = weights.clone();
  }

  /** {@link #use(List, List, ToDoubleFunction)} with all effectors healthy. */
  public void use(List<Effector> newEffectors, ToDoubleFunction<Effector> cost) {
    use(newEffectors, newEffectors, cost);
  }

  /**
   * Replaces the effectors; remaining ones keep their last commands.
   *
   * @param soundEffectors all effectors of the vehicle when none is lost or weak
   * @param cost cost of an effector's effort, above 0; costlier effectors are used less
   */
  public void use(
      List<Effector> newEffectors, List<Effector> soundEffectors, ToDoubleFunction<Effector> cost) {
    sound = List.copyOf(soundEffectors);
    soundReach = reach(sound);
    Map<String, Double> before = new LinkedHashMap<>();
    for (int i = 0; i < effectors.size(); i++) {
      before.put(effectors.get(i).name(), percents[i]);
    }
    effectors = List.copyOf(newEffectors);
    int size = effectors.size();
    costs = new double[size];
    effects = new double[size][DegreeOfFreedom.COUNT];
    percents = new double[size];
    lowest = new double[size];
    highest = new double[size];
    hessian = new double[size][size];
    linear = new double[size];
    solver = new BoundedLeastSquares(size);
    for (int i = 0; i < size; i++) {
      costs[i] = cost.applyAsDouble(effectors.get(i));
      if (!(costs[i] > 0.0 && costs[i] < 1e3)) {
        throw new IllegalArgumentException(
            "cost of " + effectors.get(i).name() + ": " + costs[i] + " is outside 0…1000");
      }
      percents[i] = before.getOrDefault(effectors.get(i).name(), 0.0);
    }
  }

  /** Records another law's command to an effector [%]. */
  public void commanded(String name, double percent) {
    for (int i = 0; i < percents.length; i++) {
      if (effectors.get(i).name().equals(name)) {
        percents[i] = percent;
      }
    }
  }

  /**
   * Distributes a wanted wrench; the result is in {@link #percent} and {@link #attained}.
   *
   * @param wanted X, Y, Z [N], K, M, N [N m]
   * @param stepS time since the previous call [s], for rate limits; 0 disables rate limits
   * @param speedMps speed through air or water [m/s], for effectors that depend on it; NaN if
   *     unknown
   */
  public void allocate(double[] wanted, double stepS, double speedMps) {
    bound(stepS, speedMps);
    for (int i = 0; i < percents.length; i++) {
      linear[i] = 0.0;
      for (int k = 0; k <= i; k++) {
        hessian[i][k] = i == k ? costs[i] : 0.0;
      }
      for (int j = 0; j < DegreeOfFreedom.COUNT; j++) {
        double weight = weight(j);
        linear[i] += weight * effects[i][j] * wanted[j];
        for (int k = 0; k <= i; k++) {
          hessian[i][k] += weight * effects[i][j] * effects[k][j];
        }
      }
      for (int k = 0; k < i; k++) {
        hessian[k][i] = hessian[i][k];
      }
    }
    Arrays.fill(attained, 0.0);
    double[] shares = solver.solve(hessian, linear, lowest, highest);
    for (int i = 0; i < percents.length; i++) {
      percents[i] = effectors.get(i).percent(shares[i]);
      for (int j = 0; j < attained.length; j++) {
        attained[j] += effects[i][j] * shares[i];
      }
    }
  }

  /**
   * Maximum effect of each effector along each axis, in either direction, at its reference speed.
   */
  private static double[][] reach(List<Effector> all) {
    double[][] reach = new double[all.size()][DegreeOfFreedom.COUNT];
    for (DegreeOfFreedom axis : AXES) {
      boolean isMeant = all.stream().anyMatch(each -> !isIncidental(each, axis));
      for (int i = 0; i < all.size(); i++) {
        Effector each = all.get(i);
        double effect = Math.abs(each.effect(axis));
        boolean asIfAligned = !isMeant && effect > 0.0;
        reach[i][axis.ordinal()] = most(each) * (asIfAligned ? norm(each, axis) : effect);
      }
    }
    return reach;
  }

  private static boolean isIncidental(Effector effector, DegreeOfFreedom axis) {
    return Math.abs(effector.effect(axis)) <= INCIDENTAL * norm(effector, axis);
  }

  private static double most(Effector effector) {
    return Math.max(effector.highest(), -effector.lowest());
  }

  /** Magnitude of an effector's force if the axis is linear, otherwise of its moment. */
  private static double norm(Effector effector, DegreeOfFreedom axis) {
    int first = axis.ordinal() < LINEAR_AXES ? 0 : LINEAR_AXES;
    double sum = 0.0;
    for (int j = first; j < first + LINEAR_AXES; j++) {
      double effect = effector.effect(AXES[j]);
      sum += effect * effect;
    }
    return Math.sqrt(sum);
  }

  private void refer(double speedMps) {
    Arrays.fill(references, 0.0);
    for (int i = 0; i < soundReach.length; i++) {
      double scale = sound.get(i).scaleAt(speedMps);
      for (int j = 0; j < references.length; j++) {
        references[j] += scale * soundReach[i][j];
      }
    }
  }

  private void bound(double stepS, double speedMps) {
    refer(speedMps);
    Arrays.fill(scales, 0.0);
    for (int i = 0; i < percents.length; i++) {
      Effector effector = effectors.get(i);
      double scale = effector.scaleAt(speedMps);
      for (DegreeOfFreedom axis : AXES) {
        double effect = scale * effector.effect(axis);
        effects[i][axis.ordinal()] = effect;
        scales[axis.ordinal()] += Math.abs(effect) * most(effector);
      }
      boolean isFree = !(stepS > 0.0);
      lowest[i] = isFree ? effector.lowest() : effector.lowestFrom(percents[i], stepS);
      highest[i] = isFree ? effector.highest() : effector.highestFrom(percents[i], stepS);
    }
  }

  private double weight(int axis) {
    if (scales[axis] == 0.0) {
      return 0.0;
    }
    double relative = weights[axis] / Math.max(references[axis], scales[axis]);
    return ERROR_OVER_EFFORT * relative * relative;
  }

  /** Wrench of the last commands, X, Y, Z [N], K, M, N [N m], at a speed [m/s]. */
  public double[] present(double speedMps) {
    double[] wrench = new double[DegreeOfFreedom.COUNT];
    for (int i = 0; i < percents.length; i++) {
      Effector effector = effectors.get(i);
      double share = effector.share(percents[i]) * effector.scaleAt(speedMps);
      for (DegreeOfFreedom axis : AXES) {
        wrench[axis.ordinal()] += share * effector.effect(axis);
      }
    }
    return wrench;
  }

  /**
   * Minimum speed at which the vehicle turns [m/s]: half the speed for the effect of its rudders; 0
   * if anything else turns it, or nothing does.
   */
  public double steerageMps() {
    double most = 0.0;
    for (Effector each : effectors) {
      most = Math.max(most, Math.abs(each.effect(DegreeOfFreedom.YAW)));
    }
    double fastest = 0.0;
    for (Effector each : effectors) {
      if (Math.abs(each.effect(DegreeOfFreedom.YAW)) > MINOR * most) {
        if (each.referenceSpeed() == 0.0) {
          return 0.0;
        }
        fastest = Math.max(fastest, each.referenceSpeed());
      }
    }
    return 0.5 * fastest;
  }

  /** The effectors, in the order of {@link #percent}. */
  public List<Effector> effectors() {
    return effectors;
  }

  /** Command of the effector at an index [%, −100…100]. */
  public double percent(int index) {
    return percents[index];
  }

  /** Force of the effector at an index [N]; negative astern. */
  public double forceN(int index) {
    return effectors.get(index).forceN(percents[index]);
  }

  /** Contribution of the effector at an index along or about an axis [N or N m]. */
  public double contribution(int index, DegreeOfFreedom axis) {
    return effects[index][axis.ordinal()] * effectors.get(index).share(percents[index]);
  }

  /** Maximum of all effectors together along or about an axis [N or N m]. */
  public double scale(DegreeOfFreedom axis) {
    return scales[axis.ordinal()];
  }

  /** Scale of errors along or about an axis [N or N m]. */
  double reference(DegreeOfFreedom axis) {
    return references[axis.ordinal()];
  }

  /** Attained force or moment along or about an axis [N or N m]. */
  public double attained(DegreeOfFreedom axis) {
    return attained[axis.ordinal()];
  }
}
