package org.u2sa.scenarios.roboboat.subvehicle;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.Pursuit;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.service.handover.HandOver;

/**
 * Fetches an object with a hovering aircraft: climbs vertically, flies above the object, descends,
 * grips, and returns the same way to the starting point. It begins to descend within the horizontal
 * threshold of the vertical line, and climbs again beyond twice the threshold. If its {@link
 * GripperSensor} detects nothing in the gripper, it tries again beside the expected position.
 */
final class FetchState implements PlannerState {
  private static final double NEAR_ALTITUDE_M = 0.3; // tolerance of the flight altitude
  private static final double SETTLED_S = 3.0; // time on the deck until the goal is completed
  private static final double BELOW_DECK_M = 1.0; // aim of a landing, for control to stop rotors
  private static final double USUAL_VERTICAL_M = 0.15; // without a vertical threshold
  private static final double BREAK_OFF = 2.0; // off the line to abort a descent [thresholds]
  private static final double FEEL_S = 1.5; // time after the grip until the load counts as missing
  private static final double BESIDE_M = 0.3; // offset of further attempts from the expected place
  private static final Point[] BESIDE = { // north, east; tried in turn
    Point.ORIGIN,
    Point.of(BESIDE_M, 0.0, 0.0),
    Point.of(-BESIDE_M, 0.0, 0.0),
    Point.of(0.0, BESIDE_M, 0.0),
    Point.of(0.0, -BESIDE_M, 0.0)
  };

  private enum Phase {
    CLIMB,
    CROSS,
    DESCEND,
    CLIMB_BACK,
    RETURN,
    LAND
  }

  private final BooleanSupplier isHolding;
  private Phase phase = Phase.CLIMB;
  private Place deck;
  private FetchGoal goal;
  private long beganMicros;
  private long thereMicros; // arrival at object or deck; Long.MIN_VALUE: not there
  private boolean gripped;
  private int misses; // number of times the gripper closed without holding anything

  /**
   * @param isHolding whether the gripper holds an object; true without a sensor
   */
  FetchState(BooleanSupplier isHolding) {
    this.isHolding = isHolding;
  }

  @Override
  public Class<? extends GoalInformation> goalClass() {
    return FetchGoal.class;
  }

  @Override
  public double distanceM(GoalInformation candidate, StateInformation state) {
    return levelM(Vehicle.of(state).orElseThrow().nedOf(Place.of((FetchGoal) candidate)));
  }

  @Override
  public void enter(Pursuit pursuit) {
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    phase = Phase.CLIMB;
    deck = vehicle.place();
    goal = (FetchGoal) pursuit.goal().copy();
    beganMicros = vehicle.timestampMicros();
    thereMicros = Long.MIN_VALUE;
    gripped = false;
    misses = 0;
  }

  @Override
  public Plan plan(Pursuit pursuit) {
    FetchGoal wanted = (FetchGoal) pursuit.goal();
    Vehicle vehicle = Vehicle.of(pursuit.state()).orElseThrow();
    Place object = Place.of(wanted);
    if (object.upM().isEmpty() || !object.isHorizontal() || vehicle.place().upM().isEmpty()) {
      return new Plan(
          List.of(), Plan.Progress.ABANDONED, "given up: goal and state need x, y and z");
    }
    String remark = proceed(wanted, object, vehicle);
    NavigationPoint point = NavigationPoint.at(vehicle.body(toGo(wanted, object, vehicle)));
    boolean isBack = phase == Phase.LAND && isThereFor(SETTLED_S, vehicle);
    boolean isFetched = gripped && isHolding.getAsBoolean();
    Plan.Progress progress =
        !isBack
            ? Plan.Progress.UNDER_WAY
            : isFetched ? Plan.Progress.COMPLETED : Plan.Progress.ABANDONED;
    if (isBack) {
      remark =
          isFetched ? "back with the object" : "given up: back without the object, " + reason();
    }
    return new Plan(List.of(point), progress, remark).changing(goal.copy());
  }

  /** Changes the phase when its end is reached. Returns a remark for the log, empty if none. */
  private String proceed(FetchGoal wanted, Place object, Vehicle vehicle) {
    double vertical = wanted.verticalThreshold().orElse(USUAL_VERTICAL_M);
    Point off = toGo(wanted, object, vehicle);
    boolean isAbove = levelM(off) <= wanted.horizontalThreshold();
    boolean isOff = levelM(off) > BREAK_OFF * wanted.horizontalThreshold();
    boolean isLevel = Math.abs(off.z()) <= NEAR_ALTITUDE_M;
    if (isGoing() && secondsSince(beganMicros, vehicle) > wanted.limit()) {
      return begin(Phase.CLIMB_BACK, "returns without the object, out of time");
    }
    switch (phase) {
      case CLIMB:
        return isLevel ? begin(Phase.CROSS, "") : "";
      case CROSS:
        return isAbove && isLevel ? begin(Phase.DESCEND, "") : "";
      case DESCEND:
        stay(isAbove && Math.abs(off.z()) <= vertical, vehicle);
        return isOff
            ? begin(Phase.CROSS, "drifted from above the object")
            : grip(wanted, off, vehicle);
      case CLIMB_BACK:
        return isLevel ? begin(Phase.RETURN, "") : "";
      case RETURN:
        return isAbove && isLevel ? begin(Phase.LAND, "") : "";
      default:
        boolean isDown = Math.abs(vehicle.nedOf(deck).z()) <= vertical;
        stay(isDown, vehicle);
        return isOff && !isDown ? begin(Phase.RETURN, "drifted from above the deck") : "";
    }
  }

  private boolean isGoing() {
    return phase == Phase.CLIMB || phase == Phase.CROSS || phase == Phase.DESCEND;
  }

  private String grip(FetchGoal wanted, Point off, Vehicle vehicle) {
    if (thereMicros != Long.MIN_VALUE && goal.arrivedAt().isEmpty()) {
      goal.arrivedAt(thereMicros);
    }
    if (!isThereFor(wanted.gripTime(), vehicle)) {
      return "";
    }
    if (!isHolding.getAsBoolean()) {
      if (!isThereFor(wanted.gripTime() + FEEL_S, vehicle)) {
        return "";
      }
      misses++;
      return begin(Phase.CROSS, "the gripper holds nothing: attempt " + (misses + 1));
    }
    gripped = true;
    return begin(
        Phase.CLIMB_BACK,
        String.format(Locale.ROOT, "gripped, %.2f m off according to the estimate", levelM(off)));
  }

  private String reason() {
    if (gripped) {
      return "lost on the way";
    }
    return misses == 0
        ? "out of time"
        : "the gripper held nothing " + (misses == 1 ? "once" : misses + " times");
  }

  private String begin(Phase next, String remark) {
    phase = next;
    thereMicros = Long.MIN_VALUE;
    return remark;
  }

  private void stay(boolean isThere, Vehicle vehicle) {
    if (!isThere) {
      thereMicros = Long.MIN_VALUE;
    } else if (thereMicros == Long.MIN_VALUE) {
      thereMicros = vehicle.timestampMicros();
    }
  }

  private boolean isThereFor(double seconds, Vehicle vehicle) {
    return thereMicros != Long.MIN_VALUE && secondsSince(thereMicros, vehicle) >= seconds;
  }

  private static double secondsSince(long micros, Vehicle vehicle) {
    return Clock.seconds(vehicle.timestampMicros() - micros);
  }

  /** Vector to the aircraft's target position: north, east, down [m]. */
  private Point toGo(FetchGoal wanted, Place object, Vehicle vehicle) {
    Point way = vehicle.nedOf(target(wanted, object));
    return phase == Phase.CROSS || phase == Phase.DESCEND
        ? way.plus(BESIDE[misses % BESIDE.length])
        : way;
  }

  /** Target position of this phase at the first attempt. */
  private Place target(FetchGoal wanted, Place object) {
    double flight =
        Math.max(deck.upM().orElseThrow(), object.upM().orElseThrow()) + wanted.height();
    switch (phase) {
      case CLIMB:
        return at(deck, flight);
      case RETURN:
        return at(deck.moved(wanted.deckNorth(), wanted.deckEast()), flight);
      case CROSS:
      case CLIMB_BACK:
        return at(object, flight);
      case DESCEND:
        return object;
      default:
        Place below = at(deck, deck.upM().orElseThrow() - BELOW_DECK_M);
        return below.moved(wanted.deckNorth(), wanted.deckEast());
    }
  }

  private static Place at(Place below, double upM) {
    return new Place(below.onEarth(), below.x(), below.y(), OptionalDouble.of(upM));
  }

  private static double levelM(Point ned) {
    return Math.hypot(ned.x(), ned.y());
  }

  @Override
  public void handOver(HandOver state) {
    state.text("FETCH PHASE", phase.name()).flag("GRIPPED", gripped).message("FETCHED", goal);
    state.number("FETCH BEGAN", Clock.seconds(beganMicros)).number("FETCH MISSES", misses);
    deck.handOver(state, "DECK");
  }

  @Override
  public boolean takeOver(HandOver state) {
    Optional<Place> from = Place.takenOver(state, "DECK");
    Optional<FetchGoal> saved = state.message("FETCHED", FetchGoal.class);
    if (from.isEmpty() || saved.isEmpty()) {
      return false;
    }
    deck = from.get();
    goal = saved.get().copy();
    phase = Phase.valueOf(state.text("FETCH PHASE").orElseThrow());
    gripped = state.flag("GRIPPED");
    beganMicros = Clock.micros(state.number("FETCH BEGAN").orElseThrow());
    misses = (int) state.number("FETCH MISSES").orElse(0.0);
    thereMicros = Long.MIN_VALUE;
    return true;
  }
}
