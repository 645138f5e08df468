package org.u2sa.control.allocation;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Maximum force or moment along and about each controlled axis.
 *
 * @param held maximum by axis while the other controlled axes stay at 0
 * @param free maximum by axis whatever the others do: thrusters that only push ahead turn a boat,
 *     though not on the spot
 */
public record Authority(Map<DegreeOfFreedom, Reach> held, Map<DegreeOfFreedom, Reach> free) {
  /** Of a vehicle without actuators. */
  public static final Authority NONE = new Authority(Map.of(), Map.of());

  private static final double OTHERS = 1e3; // weight of the axes held at 0
  private static final double BEYOND = 2.0; // demand as a multiple of the effectors' maximum
  private static final double NOTHING =
      0.05; // fraction of the healthy authority below which it counts as lost
  private static final double ALL = 0.995;
  private static final double FULL_PERCENT = 100.0;
  private static final double NOISE = 1e-3; // of the solver, as a fraction of the maximum

  /**
   * Maximum along or about an axis [N or N m].
   *
   * @param plus in its direction
   * @param minus against it
   */
  public record Reach(double plus, double minus) {
    static final Reach NONE = new Reach(0.0, 0.0);

    boolean isNone() {
      return plus == 0.0 && minus == 0.0;
    }

    /** Remaining fraction of another one in the directions that it has: rotors only lift. */
    double shareOf(Reach sound) {
      double up = sound.plus > 0.0 ? plus / sound.plus : 1.0;
      double down = sound.minus > 0.0 ? minus / sound.minus : 1.0;
      return Math.min(1.0, Math.min(up, down));
    }
  }

  /** Computes the authority of effectors at their reference speeds. */
  public static Authority of(List<Effector> effectors, Set<DegreeOfFreedom> controlled) {
    Map<DegreeOfFreedom, Reach> held = new EnumMap<>(DegreeOfFreedom.class);
    Map<DegreeOfFreedom, Reach> free = new EnumMap<>(DegreeOfFreedom.class);
    for (DegreeOfFreedom axis : controlled) {
      held.put(axis, reach(effectors, controlled, axis));
      free.put(axis, reach(effectors, EnumSet.of(axis), axis));
    }
    return new Authority(held, free);
  }

  private static Reach reach(
      List<Effector> effectors, Set<DegreeOfFreedom> held, DegreeOfFreedom axis) {
    return new Reach(most(effectors, held, axis, 1.0), most(effectors, held, axis, -1.0));
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
    double attained = sign * allocator.attained(axis);
    return attained > NOISE * sum ? attained : 0.0;
  }

  /** The controlled axes. */
  public Set<DegreeOfFreedom> axes() {
    return held.keySet();
  }

  /** Maximum in both directions: the lesser [N or N m]; 0 if the axis is not controlled. */
  public double most(DegreeOfFreedom axis) {
    Reach both = held.getOrDefault(axis, Reach.NONE);
    return Math.min(both.plus, both.minus);
  }

  /** Remaining fraction of the healthy authority about an axis, 0…1. */
  public double left(DegreeOfFreedom axis, Authority sound) {
    Reach full = sound.held.getOrDefault(axis, Reach.NONE);
    if (!full.isNone()) {
      return held.getOrDefault(axis, Reach.NONE).shareOf(full);
    }
    Reach most = sound.free.getOrDefault(axis, Reach.NONE);
    return most.isNone() ? 0.0 : free.getOrDefault(axis, Reach.NONE).shareOf(most);
  }

  /** Controlled axes with practically no authority left. */
  public List<DegreeOfFreedom> lost(Authority sound) {
    List<DegreeOfFreedom> lost = new ArrayList<>();
    for (DegreeOfFreedom axis : held.keySet()) {
      if (left(axis, sound) < NOTHING) {
        lost.add(axis);
      }
    }
    return lost;
  }

  /** Human-readable remaining authority; empty if fully available. */
  public String words(Authority sound) {
    List<String> weak = new ArrayList<>();
    for (DegreeOfFreedom axis : held.keySet()) {
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
