package org.u2sa.control.allocation;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Maximum force or moment along and about each controlled axis while the other controlled axes stay
 * at 0: the lesser of both directions.
 *
 * @param most maximum by axis [N or N m]
 */
public record Authority(Map<DegreeOfFreedom, Double> most) {
  private static final double OTHERS = 1e3; // weight of the axes held at 0
  private static final double BEYOND = 2.0; // demand as a multiple of the effectors' maximum
  private static final double NOTHING =
      0.05; // fraction of the healthy authority below which it counts as lost
  private static final double ALL = 0.995;
  private static final double FULL_PERCENT = 100.0;

  /** Computes the authority of effectors at their reference speeds. */
  public static Authority of(List<Effector> effectors, Set<DegreeOfFreedom> controlled) {
    Map<DegreeOfFreedom, Double> most = new EnumMap<>(DegreeOfFreedom.class);
    for (DegreeOfFreedom axis : controlled) {
      double up = most(effectors, controlled, axis, 1.0);
      most.put(axis, Math.min(up, most(effectors, controlled, axis, -1.0)));
    }
    return new Authority(most);
  }

  private static double most(
      List<Effector> effectors,
      Set<DegreeOfFreedom> controlled,
      DegreeOfFreedom axis,
      double sign) {
    double[] weights = new double[DegreeOfFreedom.COUNT];
    controlled.forEach(other -> weights[other.ordinal()] = other == axis ? 1.0 : OTHERS);
    double sum =
        effectors.stream()
            .mapToDouble(
                each -> Math.abs(each.effect(axis)) * Math.max(each.highest(), -each.lowest()))
            .sum();
    double[] wanted = new double[DegreeOfFreedom.COUNT];
    wanted[axis.ordinal()] = sign * BEYOND * sum;
    Allocator allocator = new Allocator(weights);
    allocator.use(effectors, each -> 1e-3);
    allocator.allocate(wanted, 0.0, Double.NaN);
    return Math.max(0.0, sign * allocator.attained(axis));
  }

  /** Remaining fraction of the healthy authority about an axis, 0…1. */
  public double left(DegreeOfFreedom axis, Authority sound) {
    double full = sound.most.getOrDefault(axis, 0.0);
    return full > 0.0 ? Math.min(1.0, most.getOrDefault(axis, 0.0) / full) : 0.0;
  }

  /** Controlled axes with practically no authority left. */
  public List<DegreeOfFreedom> lost(Authority sound) {
    List<DegreeOfFreedom> lost = new ArrayList<>();
    for (DegreeOfFreedom axis : most.keySet()) {
      if (left(axis, sound) < NOTHING) {
        lost.add(axis);
      }
    }
    return lost;
  }

  /** Human-readable remaining authority; empty if fully available. */
  public String words(Authority sound) {
    List<String> weak = new ArrayList<>();
    for (DegreeOfFreedom axis : most.keySet()) {
      double left = left(axis, sound);
      if (left >= NOTHING && left < ALL) {
        weak.add(axis + " " + Math.round(FULL_PERCENT * left) + " %");
      }
    }
    List<DegreeOfFreedom> lost = lost(sound);
    String left = weak.isEmpty() ? "" : "authority left: " + String.join(", ", weak);
    if (lost.isEmpty()) {
      return left;
    }
    List<String> names = new ArrayList<>();
    lost.forEach(axis -> names.add(axis.toString()));
    return left + (left.isEmpty() ? "" : "; ") + "cannot control " + String.join(", ", names);
  }
}
