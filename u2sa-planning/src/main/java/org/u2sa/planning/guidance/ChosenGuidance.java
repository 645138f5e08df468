package org.u2sa.planning.guidance;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * Delegates to the guidance currently configured; both are kept up to date on each leg, so that it
 * can change en route.
 */
public final class ChosenGuidance implements WaypointGuidance {
  private static final String LINE = "LINE";
  private static final String DIRECT = "DIRECT";

  private final Supplier<String> name;
  private final Map<String, GuidanceLaw> laws = new LinkedHashMap<>();
  private final WaypointGuidance lines;
  private final WaypointGuidance direct = new DirectGuidance();

  /**
   * @param configuration configuration of the planner, in which GUIDANCE names LINE, DIRECT or an
   *     extension's law
   */
  public ChosenGuidance(Configurator configuration, Supplier<LineSettings> settings) {
    laws.put(LINE, GuidanceLaw.carrot());
    for (GuidanceLawProvider provider : ServiceLoader.load(GuidanceLawProvider.class)) {
      laws.putIfAbsent(provider.name(), provider.law(configuration));
    }
    List<String> names = new ArrayList<>(laws.keySet());
    names.add(1, DIRECT);
    VariableDeclaration<String> guidance =
        VariableDeclaration.text("GUIDANCE")
            .oneOf(names.toArray(new String[0]))
            .ifAbsent(LINE)
            .describedAs(
                "LINE follows the lines between waypoints; DIRECT heads straight for the waypoint and hands control unit vectors (thesis 4.5.2.4); others are laws of extensions.");
    name = () -> configuration.getVariable(guidance);
    name.get(); // an invalid value must fail before the vehicle moves
    lines =
        new LineGuidance(
            settings, (leg, lookAheadM) -> laws.get(lawName()).pointAhead(leg, lookAheadM));
  }

  /** Line law used for legs and turns, even while DIRECT is selected: that can change en route. */
  private String lawName() {
    return name.get().equals(DIRECT) ? LINE : name.get();
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
