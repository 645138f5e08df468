package org.u2sa.planning;

import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * {@link Landing}: descends along a straight approach or vertically; completed when the vehicle has
 * been at rest for a while, abandoned when it lies on its side or stands far from the position,
 * also above it.
 */
final class LandingState implements PlannerState {
  private static final double STILL_MPS = 0.25;
  private static final double STANDS_S = 2.0;
  private static final double STANDS_HIGH_S = 10.0; // on ground that should be lower
  private static final double COS_ON_SIDE = 0.5; // 60 deg from upright
  private static final double LOW_M = 3.0; // height above the ground given by the goal
  private static final double SIGMAS = 2.0; // possible height error, in standard deviations
  private static final double TOUCHES_M = 1.0; // height of a touch-down
  private static final double TOUCHES_S = 1.0; // led down at rest for so long, it has touched down
  private static final double SINKS_SHARE = 0.2; // fraction of the touch-down sink rate, in the air

  /** One way to land. */
  interface Descent {
    void begin(Landing goal, StateInformation state, Vehicle vehicle);

    Plan plan(Landing goal, StateInformation state, Vehicle vehicle);

    /** Whether the vehicle is on its final descent: if it does not sink, it has landed. */
    boolean isFinal();

    /** Distance from the position beyond which the vehicle has landed elsewhere [m]. */
    double farM(Landing goal);
  }

  private final Detour detour;
  private final Supplier<LineSettings> lines;
  private final Descent straight;
  private final Descent vertical;
  private final Supplier<FlightVariables> settings;
  private long sinceMicros = Long.MIN_VALUE; // when it stopped
  private double sinceDownM; // remaining height then [m]
  private boolean touches; // or is on the ground

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
    sinceMicros = Long.MIN_VALUE;
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    descent().begin((Landing) pursuit.goal(), pursuit.state(), vehicle);
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
    double upright =
        Math.cos(pursuit.state().phi().orElse(0.0)) * Math.cos(pursuit.state().theta().orElse(0.0));
    // A vehicle that waits above something does not sink either.
    boolean waits = descent() == vertical && detour.isHeldUp() && upright >= COS_ON_SIDE;
    boolean mayStand = descent().isFinal() && !waits;
    touches = mayStand && downM < TOUCHES_M;
    if (!mayStand || Math.hypot(vehicle.speedMps(), climbMps) > STILL_MPS) {
      sinceMicros = Long.MIN_VALUE;
      return plan;
    }
    long now = vehicle.timestampMicros();
    if (sinceMicros == Long.MIN_VALUE) {
      sinceMicros = now;
      sinceDownM = downM;
    }
    double stillS = Clock.seconds(now - sinceMicros);
    touches |= stillS > TOUCHES_S;
    if (stillS < (isLow ? STANDS_S : STANDS_HIGH_S)) {
      return plan;
    }
    if (sinceDownM - downM > SINKS_SHARE * settings.get().touchDownSink() * stillS) {
      sinceMicros = Long.MIN_VALUE; // it still sinks, slowly
      return plan;
    }
    double awayM = distanceM(goal, pursuit.state());
    String stands =
        isLow
            ? String.format(Locale.ROOT, "stands %.1f m from its position", awayM)
            : String.format(Locale.ROOT, "stands %.1f m above its position", downM);
    if (isLow && upright >= COS_ON_SIDE && awayM <= descent().farM(goal)) {
      return new Plan(List.copyOf(plan.points()), Plan.Progress.COMPLETED, stands);
    }
    String reason = "given up: " + (upright < COS_ON_SIDE ? "has tipped over" : stands);
    return new Plan(List.of(), Plan.Progress.ABANDONED, reason);
  }
}
