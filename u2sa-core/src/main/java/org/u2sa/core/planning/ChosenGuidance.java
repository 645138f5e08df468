package org.u2sa.core.planning;

import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.HandOver;

/**
 * The guidance that the configuration names at the moment; both know of each leg, so that it may
 * change on the way.
 */
final class ChosenGuidance implements WaypointGuidance {
  static final String LINE = "LINE";
  private static final String DIRECT = "DIRECT";

  private final Supplier<String> name;
  private final Map<String, GuidanceLaw> laws = new TreeMap<>();
  private final WaypointGuidance lines;
  private final WaypointGuidance direct = new DirectGuidance();

  /**
   * @param name LINE, DIRECT or the name of an extension's law, as {@link #requireKnown} has it
   * @param configuration the planner's, for laws
   */
  ChosenGuidance(
      Supplier<String> name, Supplier<LineSettings> settings, Configurator configuration) {
    this.name = name;
    laws.put(LINE, GuidanceLaw.carrot());
    for (GuidanceLawProvider provider : ServiceLoader.load(GuidanceLawProvider.class)) {
      laws.putIfAbsent(provider.name(), provider.law(configuration));
    }
    lines =
        new LineGuidance(
            settings, (leg, lookAheadM) -> laws.get(lawName()).pointAhead(leg, lookAheadM));
  }

  /** Altitudes and turns are a line's even while DIRECT is chosen: it may change on the way. */
  private String lawName() {
    return name.get().equals(DIRECT) ? LINE : name.get();
  }

  /**
   * Refuses a guidance that nobody provides.
   *
   * @throws IllegalArgumentException listing what there is
   */
  static void requireKnown(String guidance) {
    Set<String> known = new TreeSet<>(Set.of(LINE, DIRECT));
    for (GuidanceLawProvider provider : ServiceLoader.load(GuidanceLawProvider.class)) {
      known.add(provider.name());
    }
    if (!known.contains(guidance)) {
      throw new IllegalArgumentException(
          "GUIDANCE \"" + guidance + "\" is not one of " + String.join(", ", known));
    }
  }

  private WaypointGuidance chosen() {
    return name.get().equals(DIRECT) ? direct : lines;
  }

  @Override
  public void begin(Optional<Place> start) {
    lines.begin(start);
    direct.begin(start);
  }

  @Override
  public Point towards(Vehicle vehicle, Place target, double threshold, Optional<Place> after) {
    return chosen().towards(vehicle, target, threshold, after);
  }

  @Override
  public Point bodyPoint(Vehicle vehicle, Point ned) {
    return chosen().bodyPoint(vehicle, ned);
  }

  @Override
  public boolean hasPassed() {
    return chosen().hasPassed();
  }

  @Override
  public boolean isNearest() {
    return chosen().isNearest();
  }

  @Override
  public boolean isApproaching() {
    return chosen().isApproaching();
  }

  @Override
  public void handOver(HandOver state) {
    lines.handOver(state);
  }

  @Override
  public void takeOver(HandOver state) {
    lines.takeOver(state);
  }
}
