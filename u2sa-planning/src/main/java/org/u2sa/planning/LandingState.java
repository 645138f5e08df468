package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.planning.flight.FlightVariables;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * {@link Landing}: descends along a straight approach or vertically; completed when the vehicle has
 * been at rest for a while, abandoned when it lies on its side, also on the way there, or stands
 * far from the position, also above it.
 */
final class LandingState implements PlannerState {
  private static final double STILL_MPS = 0.25;
  private static final double LIES_MPS = 1.0; // on its side, horizontally: errors of a lost IMU
  private static final double STANDS_S = 2.0;
  private static final double STANDS_HIGH_S = 10.0; // on ground that should be lower
  private static final double ON_SIDE_RAD = Math.toRadians(60.0); // from upright
  private static final double LOW_M = 3.0; // height above the ground given by the goal
  private static final double SIGMAS = 2.0; // possible height error, in standard deviations
  private static final double TOUCHES_M = 1.0; // height of a touch-down
  private static final double TOUCHES_S = 1.0; // led down at rest for so long, it has touched down
  private static final double HARD_MPS = 4.0; // sink rate of a multirotor that falls
  private static final double SINKS_SHARE = 0.2; // fraction of the touch-down sink rate, in the air

  /** One way to land. */
  interface Descent {
    void begin(Landing goal, StateInformation state, Vehicle vehicle);

    Plan plan(Landing goal, StateInformation state, Vehicle vehicle);

    /** Whether the vehicle is on its final descent: if it does not sink, it has landed. */
    boolean isFinal();

    /** Distance from the position beyond which the vehicle has landed elsewhere [m]. */
    double farM(Landing goal);

    /** What must not begin again near the ground; empty for the rest. */
    String manoeuvre();

    void handOver(HandOver state);

    /**
     * Continues the descent of the previous planner.
     *
     * @return false if nothing was handed over
     */
    boolean takeOver(HandOver state);

    /**
     * Whether the vehicle can continue a {@linkplain #manoeuvre} that was {@linkplain #takeOver
     * taken over}.
     */
    boolean isStillIn(String manoeuvre, Landing goal, Vehicle vehicle);
  }

  private final Detour detour;
  private final Supplier<LineSettings> lines;
  private final Descent straight;
  private final Descent vertical;
  private final Supplier<FlightVariables> settings;
  private long sinceMicros = Long.MIN_VALUE; // when it stopped
  private double sinceDownM; // remaining height then [m]
  private boolean touches; // or is on the ground
  private double fellMps; // greatest sink rate while low
  private String told = ""; // manoeuvre

  LandingState(
      Detour detour,
      Supplier<LineSettings> lines,
      StationCircle circle,
      Supplier<FlightVariables> settings) {
    this.detour = detour;
    this.lines = lines;
    this.settings = settings;
    straight = new StraightApproach(detour, lines, circle, settings);
    vertical = new VerticalDescent(detour, lines, settings);
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return Landing.class;
  }

  @Override
  public double distanceM(GoalInformation goal, StateInformation state) {
    Point ned = Vehicle.of(state).orElseThrow().nedOf(Place.of((Landing) goal));
    return Math.hypot(ned.x(), ned.y());
  }

  private Descent descent() {
    return lines.get().turns().accelerationMps2() > 0.0 ? straight : vertical;
  }

  @Override
  public void enter(Pursuit pursuit) {
    touches = false;
    fellMps = 0.0;
    sinceMicros = Long.MIN_VALUE;
    told = "";
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    descent().begin((Landing) pursuit.goal(), pursuit.state(), vehicle);
  }

  @Override
  public boolean isNews() {
    boolean isNews = !told.equals(descent().manoeuvre());
    told = descent().manoeuvre();
    return isNews;
  }

  @Override
  public void resume(HandOver state, Pursuit pursuit) {
    Landing goal = (Landing) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    boolean isTaken = descent().takeOver(state);
    if (!isTaken || !descent().isStillIn(descent().manoeuvre(), goal, vehicle)) {
      descent().begin(goal, pursuit.state(), vehicle);
    }
  }

  @Override
  public void handOver(HandOver state) {
    descent().handOver(state);
    state.flag("TOUCHES", touches).number("FELL", fellMps);
    if (sinceMicros != Long.MIN_VALUE) {
      state.number("STILL SINCE", Clock.seconds(sinceMicros)).number("STILL AT", sinceDownM);
    }
  }

  @Override
  public boolean takeOver(HandOver state) {
    touches = state.flag("TOUCHES");
    fellMps = state.number("FELL").orElse(0.0);
    OptionalDouble since = state.number("STILL SINCE");
    sinceMicros = since.isPresent() ? Clock.micros(since.getAsDouble()) : Long.MIN_VALUE;
    sinceDownM = state.number("STILL AT").orElse(0.0);
    return descent().takeOver(state);
  }

  @Override
  public boolean touchesDown() {
    return touches;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    Landing goal = (Landing) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    Plan plan = descent().plan(goal, pursuit.state(), vehicle);
    double downM = vehicle.nedOf(Place.of(goal)).z();
    double climbMps = pursuit.state().zDot().orElse(0.0);
    boolean isLow = downM < LOW_M + SIGMAS * pursuit.state().zSigma().orElse(0.0);
    double tiltRad = tiltRad(pursuit.state());
    fellMps = isLow && descent().isFinal() ? Math.max(fellMps, vehicle.downMps()) : 0.0;
    // A vehicle that waits above something does not sink either.
    boolean waits = descent() == vertical && detour.isHeldUp() && tiltRad <= ON_SIDE_RAD;
    boolean isLanding = descent().isFinal() && !waits;
    // One that has crashed lies wherever it is, and its state may err by more than usual.
    boolean lies = !fallen(pursuit.state()).isEmpty() && !waits;
    touches = isLanding && downM < TOUCHES_M;
    boolean isStill =
        lies
            ? vehicle.speedMps() <= LIES_MPS && Math.abs(climbMps) <= STILL_MPS
            : isLanding && Math.hypot(vehicle.speedMps(), climbMps) <= STILL_MPS;
    if (!isStill) {
      sinceMicros = Long.MIN_VALUE;
      return plan;
    }
    long now = vehicle.timestampMicros();
    if (sinceMicros == Long.MIN_VALUE) {
      sinceMicros = now;
      sinceDownM = downM;
    }
    double stillS = Clock.seconds(now - sinceMicros);
    touches |= isLanding && stillS > TOUCHES_S;
    if (stillS < (isLow && isLanding ? STANDS_S : STANDS_HIGH_S)) {
      return plan;
    }
    if (!lies && sinceDownM - downM > SINKS_SHARE * settings.get().touchDownSink() * stillS) {
      sinceMicros = Long.MIN_VALUE; // it still sinks, slowly
      return plan;
    }
    double awayM = distanceM(goal, pursuit.state());
    String stands =
        isLow
            ? String.format(Locale.ROOT, "stands %.1f m from its position", awayM)
            : String.format(Locale.ROOT, "stands %.1f m above its position", downM);
    String damage = damage(pursuit.state());
    if (isLow && damage.isEmpty() && awayM <= descent().farM(goal)) {
      return new Plan(List.copyOf(plan.points()), Plan.Progress.COMPLETED, stands);
    }
    String reason = "given up: " + (damage.isEmpty() ? stands : damage);
    return new Plan(List.of(), Plan.Progress.ABANDONED, reason);
  }

  /** Why the vehicle may be damaged although it is at rest; empty if nothing says so. */
  private String damage(StateInformation state) {
    return tiltRad(state) <= ON_SIDE_RAD && descent() == vertical && fellMps > HARD_MPS
        ? String.format(Locale.ROOT, "hit the ground at %.0f m/s", fellMps)
        : fallen(state);
  }

  /** Whether the vehicle may lie on its side, in words; empty if it does not. */
  private static String fallen(StateInformation state) {
    double sigmaRad = Math.max(state.phiSigma().orElse(0.0), state.thetaSigma().orElse(0.0));
    if (tiltRad(state) > ON_SIDE_RAD) {
      return "has tipped over";
    }
    return tiltRad(state) + SIGMAS * sigmaRad > ON_SIDE_RAD
        ? "may have tipped over, roll and pitch are unknown"
        : "";
  }

  /** Angle from upright [rad]; 0 if roll and pitch are unknown. */
  private static double tiltRad(StateInformation state) {
    double upright = Math.cos(state.phi().orElse(0.0)) * Math.cos(state.theta().orElse(0.0));
    return Math.acos(upright);
  }
}
