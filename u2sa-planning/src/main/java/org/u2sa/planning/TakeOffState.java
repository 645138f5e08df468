package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * {@link TakeOff}: along the runway and its extension, or vertically, to the altitude. Abandoned if
 * the vehicle moves, but does not climb for a minute.
 */
final class TakeOffState implements PlannerState {
  private static final double CLIMBS_WITHIN_S = 60.0;
  private static final double CLIMBS_M = 1.0;
  private static final double FLIES_M = 2.0; // above the start
  private static final double FLIES_MPS = 5.0; // or rolls

  private final Supplier<LineSettings> lines;
  private final Supplier<FlightVariables> settings;
  private final BooleanSupplier isAeroplane;
  private Optional<Place> from = Optional.empty();
  private double headingRad;
  private double highestM; // above the start
  private long climbedMicros; // when it came there, or last stood

  TakeOffState(
      Supplier<LineSettings> lines,
      Supplier<FlightVariables> settings,
      BooleanSupplier isAeroplane) {
    this.lines = lines;
    this.settings = settings;
    this.isAeroplane = isAeroplane;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return TakeOff.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    return 0.0; // it starts at the vehicle's position
  }

  @Override
  public void enter(Pursuit pursuit) {
    begin((TakeOff) pursuit.goal(), Vehicle.of(pursuit.state()).orElseThrow());
  }

  private void begin(TakeOff goal, Vehicle vehicle) {
    from = Optional.of(vehicle.place());
    headingRad = goal.psi().orElse(vehicle.headingRad());
    highestM = Double.NEGATIVE_INFINITY;
  }

  @Override
  public void handOver(HandOver state) {
    from.ifPresent(place -> place.handOver(state, "TAKE OFF"));
    state.number("TAKE OFF HEADING", headingRad);
  }

  @Override
  public boolean takeOver(HandOver state) {
    from = Place.takenOver(state, "TAKE OFF");
    highestM = Double.NEGATIVE_INFINITY;
    OptionalDouble heading = state.number("TAKE OFF HEADING");
    heading.ifPresent(known -> headingRad = known);
    return from.isPresent() && heading.isPresent();
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    TakeOff goal = (TakeOff) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    double downM = vehicle.nedOf(Place.of(goal)).z();
    Point start = vehicle.nedOf(from.orElseThrow());
    double aheadM = 0.0;
    if (lines.get().turns().accelerationMps2() > 0.0) {
      double cos = Math.cos(headingRad);
      double sin = Math.sin(headingRad);
      double alongM = -(start.x() * cos + start.y() * sin);
      aheadM = alongM + lines.get().lookAheadM(vehicle.speedMps());
    }
    Point ned =
        Point.of(
            start.x() + aheadM * Math.cos(headingRad),
            start.y() + aheadM * Math.sin(headingRad),
            downM);
    NavigationPoint point = NavigationPoint.at(vehicle.body(ned));
    goal.speed().ifPresent(point::speed);
    List<NavigationPoint> points = List.of(point);
    double accuracyM = settings.get().takeOffAccuracyM(isAeroplane.getAsBoolean());
    if (-downM > goal.verticalThreshold().orElse(accuracyM)) {
      return Plan.unless(stopsClimbing(vehicle, start.z()), points);
    }
    String side = downM < 0.0 ? "below" : "above";
    String remark =
        String.format(Locale.ROOT, "in the air, %.1f m %s its altitude", Math.abs(downM), side);
    return new Plan(points, Plan.Progress.COMPLETED, remark);
  }

  private Optional<String> stopsClimbing(Vehicle vehicle, double heightM) {
    boolean stands = heightM < FLIES_M && vehicle.speedMps() < FLIES_MPS;
    if (stands || heightM > highestM + CLIMBS_M) {
      highestM = heightM;
      climbedMicros = vehicle.timestampMicros();
    }
    return Clock.seconds(vehicle.timestampMicros() - climbedMicros) > CLIMBS_WITHIN_S
        ? Optional.of(
            String.format(Locale.ROOT, "no higher than %.0f m for a minute", highestM + CLIMBS_M))
        : Optional.empty();
  }
}
