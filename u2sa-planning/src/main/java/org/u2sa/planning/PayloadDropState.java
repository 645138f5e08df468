package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.AirMass;
import org.u2sa.planning.guidance.LineGuidance;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.payload.Fall;
import org.u2sa.planning.payload.PayloadReleases;
import org.u2sa.service.handover.HandOver;

/**
 * {@link PayloadDrop}: flies such that the computed fall ends at the position, passing upwind of it
 * in a crosswind, and releases the payload. A multirotor hovers upwind of it. Completed if the
 * release mechanism reports that it has moved.
 */
final class PayloadDropState implements PlannerState {
  private static final int ATTEMPTS = 3;
  private static final double RELEASING_S = 1.0; // minimum duration of the release command
  private static final double CONFIRMED_S = 2.0; // after this and the delay, nothing was released
  private static final double SAFE_S = 1.5; // between two commands: the mechanism locks
  private static final double ANNOUNCED_S = 10.0; // within which mechanisms have been announced
  private static final double HOVERS_MPS = 0.5;
  private static final double HOVER_SHARE = 0.5; // of the threshold, when hovering
  private static final double HEIGHT_ERROR_M = 2.0; // without vertical threshold
  private static final double HEIGHT_SHARE = 0.1; // of the height; the larger of both applies

  private final DropApproach approach;
  private final Supplier<LineSettings> lines;
  private final Supplier<FlightVariables> settings;
  private final PayloadReleases releases;
  private final LineGuidance guidance;
  private long enteredMicros;
  private double altitudeM; // altitude on the way there
  private int attempts;
  private double beforeM; // distance by which the fall ended short at the last state
  private long releasedMicros;
  private boolean isReported; // by the mechanism
  private int changesBefore; // of the mechanism's position
  private long commandedMicros; // when a release was last commanded
  private String remark = "";

  PayloadDropState(
      Detour detour,
      Supplier<LineSettings> lines,
      Supplier<FlightVariables> settings,
      PayloadReleases releases) {
    this.releases = releases;
    approach = new DropApproach(detour);
    this.lines = lines;
    this.settings = settings;
    guidance = new LineGuidance(lines);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return PayloadDrop.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Point ned = Vehicle.of(state).orElseThrow().nedOf(Place.of((PayloadDrop) goal));
    return Math.hypot(ned.x(), ned.y());
  }

  @Override
  public void enter(Pursuit pursuit) {
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    altitudeM = vehicle.place().upM().orElse(0.0);
    enteredMicros = vehicle.timestampMicros();
    attempts = 1;
    releasedMicros = Long.MIN_VALUE;
    approach();
  }

  @Override
  public void handOver(HandOver state) {
    if (releasedMicros != Long.MIN_VALUE) {
      state.number("DROP RELEASED", Clock.seconds(releasedMicros)).number("DROP FROM", altitudeM);
      state.text("DROP REMARK", remark);
      state.flag("DROP REPORTED", isReported);
    }
  }

  /** Resumes only after the release: a payload is not dropped twice. */
  @Override
  public boolean takeOver(HandOver state) {
    if (state.number("DROP RELEASED").isEmpty()) {
      return false;
    }
    releasedMicros = Clock.micros(state.number("DROP RELEASED").getAsDouble());
    altitudeM = state.number("DROP FROM").orElseThrow();
    remark = state.text("DROP REMARK").orElse("");
    isReported = state.flag("DROP REPORTED");
    approach();
    return true;
  }

  private void approach() {
    approach.begin();
    straighten();
  }

  /** Begins the straight leg to the release point. */
  private void straighten() {
    guidance.begin(Optional.empty());
    beforeM = Double.NEGATIVE_INFINITY;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    PayloadDrop goal = (PayloadDrop) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    Place place = Place.of(goal);
    Point to = vehicle.nedOf(place);
    boolean hovers = lines.get().turns().accelerationMps2() == 0.0;
    Point velocity = Point.of(vehicle.northMps(), vehicle.eastMps(), vehicle.downMps());
    Optional<Point> wind = AirMass.wind(pursuit.state(), vehicle);
    Fall fall =
        Fall.from(Math.max(0.0, to.z()), velocity, wind.orElse(Point.ORIGIN), goal.terminalSpeed());
    Point impact = fall.way().plus(velocity.times(settings.get().releaseDelay()));
    Point miss = Point.of(to.x() - impact.x(), to.y() - impact.y(), 0.0);
    double course = vehicle.courseRad();
    double shortM = miss.x() * Math.cos(course) + miss.y() * Math.sin(course);
    double across = miss.y() * Math.cos(course) - miss.x() * Math.sin(course);

    double upM = place.upM().orElseThrow();
    double flyAtM = goal.height().isPresent() ? upM + goal.height().getAsDouble() : altitudeM;
    Point aside = hovers ? impact : sideways(impact, course);
    Place aim = place.moved(-aside.x(), -aside.y()).at(flyAtM);
    Optional<Plan> around =
        releasedMicros == Long.MIN_VALUE
            ? approach.step(goal, vehicle, pursuit.state(), aim, guidance.isApproaching())
            : Optional.empty();
    if (around.isPresent()) {
      straighten();
    }
    NavigationPoint point =
        NavigationPoint.at(guidance.towards(vehicle, aim, 1.0, Optional.empty()));
    goal.speed().ifPresent(point::speed);
    if (around.isPresent()) {
      return around.get();
    }

    double highM = to.z() - (flyAtM - upM);
    double mostM =
        goal.verticalThreshold().orElse(Math.max(HEIGHT_ERROR_M, HEIGHT_SHARE * (flyAtM - upM)));
    boolean isAbove =
        hovers
            ? Math.hypot(vehicle.speedMps(), vehicle.downMps()) < HOVERS_MPS
                && miss.distance() <= HOVER_SHARE * goal.horizontalThreshold()
            : beforeM > 0.0 && shortM <= 0.0 && Math.abs(across) <= goal.horizontalThreshold();
    beforeM = shortM;
    long now = vehicle.timestampMicros();
    Optional<String> missing = releases.missing(goal.payload());
    if (releasedMicros == Long.MIN_VALUE
        && missing.isPresent()
        && Clock.seconds(now - enteredMicros) > ANNOUNCED_S) {
      return Plan.unless(missing, List.of(point));
    }
    boolean isNow =
        isAbove
            && Math.abs(highM) <= mostM
            && missing.isEmpty()
            && now - commandedMicros >= Clock.micros(SAFE_S);
    if (releasedMicros == Long.MIN_VALUE && isNow) {
      releasedMicros = now;
      isReported = false;
      changesBefore = releases.changes(goal.payload());
      remark =
          String.format(
              Locale.ROOT,
              "released %.0f m before it, wind %s, falls for %.1f s",
              Math.hypot(to.x(), to.y()),
              wind.map(each -> String.format(Locale.ROOT, "%.1f m/s", each.distance()))
                  .orElse("unknown"),
              fall.timeS());
    }
    if (releasedMicros != Long.MIN_VALUE) {
      return released(goal, vehicle, point, to);
    }
    return !hovers && guidance.hasPassed()
        ? missed(point, Math.abs(highM) <= mostM ? across : 0.0, highM)
        : Plan.underWay(List.of(point));
  }

  private static Point sideways(Point way, double course) {
    double right = way.y() * Math.cos(course) - way.x() * Math.sin(course);
    return Point.of(-right * Math.sin(course), right * Math.cos(course), 0.0);
  }

  private Plan released(PayloadDrop goal, Vehicle vehicle, NavigationPoint point, Point to) {
    long now = vehicle.timestampMicros();
    isReported |= releases.changes(goal.payload()) > changesBefore;
    double sinceS = Clock.seconds(now - releasedMicros);
    if (isReported && sinceS >= RELEASING_S) {
      return new Plan(List.of(point), Plan.Progress.COMPLETED, remark);
    }
    if (!isReported && sinceS >= CONFIRMED_S + settings.get().releaseDelay()) {
      return Plan.unless(
          Optional.of("\"" + goal.payload() + "\" did not report a release"), List.of(point));
    }
    commandedMicros = now;
    NavigationPoint release = NavigationPoint.at(vehicle.body(to)).subsystem(goal.payload());
    return Plan.underWay(List.of(point, release));
  }

  private Plan missed(NavigationPoint point, double acrossM, double highM) {
    String off =
        acrossM == 0.0
            ? String.format(
                Locale.ROOT, "was %.0f m too %s", Math.abs(highM), highM > 0.0 ? "high" : "low")
            : String.format(Locale.ROOT, "would have missed by %.0f m", Math.abs(acrossM));
    if (attempts >= ATTEMPTS) {
      return new Plan(List.of(point), Plan.Progress.ABANDONED, "given up: " + off);
    }
    attempts++;
    approach();
    return new Plan(List.of(point), Plan.Progress.UNDER_WAY, off + ": trying again");
  }
}
