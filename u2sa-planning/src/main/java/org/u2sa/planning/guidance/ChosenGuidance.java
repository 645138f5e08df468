package org.u2sa.planning.guidance;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Supplier;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * Delegates to the guidance currently configured; all are kept up to date on each leg, so that the
 * law can change en route.
 */
public final class ChosenGuidance implements WaypointGuidance {
  private static final String LINE = "LINE";
  private static final String DIRECT = "DIRECT";

  private static final String ILOS = "ILOS";

  private record Integral(
      @Variable(unit = "m/s", min = 0, max = 10, ifAbsent = 0.1)
          @Description("Integral gain of ILOS; up to about a quarter of the usual speed.")
          double crossTrackGain) {}

  private final Supplier<String> name;
  private final Map<String, GuidanceLaw> laws = new LinkedHashMap<>();
  private final WaypointGuidance lines;
  private final WaypointGuidance direct = new DirectGuidance();

  /**
   * @param configuration configuration of the planner, in which GUIDANCE names LINE, DIRECT, ILOS
   *     or an extension's law
   */
  public ChosenGuidance(Configurator configuration, Supplier<LineSettings> settings) {
    laws.put(LINE, GuidanceLaw.carrot());
    Settings<Integral> integral = configuration.settings(Integral.class);
    laws.put(ILOS, new IntegralLineOfSight(() -> integral.get().crossTrackGain()));
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
                "LINE follows the lines between waypoints; ILOS also compensates a boat's drift from wind and current; DIRECT heads straight for the waypoint and hands control unit vectors (thesis 4.5.2.4); others are laws of extensions.");
    name = () -> configuration.getVariable(guidance);
    name.get(); // an invalid value must fail before the vehicle moves
    lines = new LineGuidance(settings, new ChosenLaw());
  }

  /** The configured law; all laws start together, because another can be chosen en route. */
  private final class ChosenLaw implements GuidanceLaw {
    private GuidanceLaw law() {
      return laws.get(lawName());
    }

    @Override
    public Point pointAhead(Leg leg, double lookAheadM) {
      return law().pointAhead(leg, lookAheadM);
    }

    @Override
    public void begin() {
      laws.values().forEach(GuidanceLaw::begin);
    }

    @Override
    public void advance(Leg leg, double lookAheadM, double stepS) {
      law().advance(leg, lookAheadM, stepS);
    }

    @Override
    public void handOver(HandOver state) {
      law().handOver(state);
    }

    @Override
    public void takeOver(HandOver state) {
      law().takeOver(state);
    }
  }

  /** Line law for legs and turns, even while DIRECT is selected, which can change en route. */
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
