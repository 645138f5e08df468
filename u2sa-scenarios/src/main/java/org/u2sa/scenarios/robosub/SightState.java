package org.u2sa.scenarios.robosub;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.planning.Plan;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerView;
import org.u2sa.planning.Pursuit;

/**
 * Approaches a position defined by objects of the world model, up to the task's distance. Searches
 * ahead and then around while the objects are unknown, and gives up after a while.
 */
abstract class SightState implements PlannerState {
  private static final double UNKNOWN_M = 1.0e6; // assumed if a task's objects are unseen
  private static final double GIVE_UP_S = 60.0; // time without sight of the objects
  private static final double STRAIGHT_S = 12.0; // search straight ahead, then around, in turn
  private static final double AROUND_S = 15.0;
  private static final double BLIND_S = 40.0; // without any sighting, only looks around
  private static final double AROUND_RAD = 0.3; // heading ahead of the vehicle's, to keep turning
  private static final double FACED_M =
      0.7; // nearer positions are approached without turning toward them

  final PlannerView surroundings;
  private final TaskSight sight;
  private Optional<Point> aim = Optional.empty(); // on the planner's plane
  private long enteredMicros;
  private long seenMicros;

  SightState(TaskSight sight) {
    this.sight = sight;
    surroundings = sight.surroundings;
  }

  /**
   * Target on the planner's plane; empty while out of sight. By default, the object of the first
   * type.
   */
  Optional<Point> aim(SubTask task, StateInformation state) {
    return task.objectTypes().stream().findFirst().flatMap(type -> place(type, state));
  }

  /** Minimum number of object types that the goal must name; 0 by default. */
  int typesNeeded() {
    return 0;
  }

  /** Next step towards the place. */
  abstract Plan approach(SubTask task, StateInformation state, Point way);

  @Override
  public final void enter(Pursuit pursuit) {
    surroundings.begin();
    aim = Optional.empty();
    enteredMicros = micros(pursuit.state());
    seenMicros = enteredMicros;
    begin();
  }

  /** Resets the task's own state. */
  void begin() {}

  private static long micros(StateInformation state) {
    return state.timestamp().orElseThrow();
  }

  /** Accepts objects in BODY. */
  @Override
  public final boolean needsNoState() {
    return true;
  }

  @Override
  public final double distanceM(GoalInformation goal, StateInformation state) {
    return aim((SubTask) goal, state)
        .map(place -> place.minus(surroundings.here(state)).distance())
        .orElse(UNKNOWN_M);
  }

  @Override
  public final Plan plan(Pursuit pursuit) {
    SubTask task = (SubTask) pursuit.goal();
    StateInformation state = pursuit.state();
    if (task.objectTypes().size() < typesNeeded()) {
      return abandoned(
          "objectTypes: " + task.objectTypes() + ", expected " + typesNeeded() + " types");
    }
    long now = micros(state);
    Optional<Point> seen = aim(task, state);
    if (seen.isPresent()) {
      aim = seen;
      seenMicros = now;
    } else if (state.referenceFrame().isLocal()) {
      aim = Optional.empty(); // relative to the vehicle, which has moved since
    }
    double unseenS = Clock.seconds(now - seenMicros);
    boolean isBlind = Clock.seconds(now - sight.lastMicros(seen.isPresent(), now)) > BLIND_S;
    if (aim.isEmpty()) {
      return search(task, unseenS, Clock.seconds(now - enteredMicros), isBlind);
    }
    return approach(task, state, aim.get().minus(surroundings.here(state)));
  }

  private static Plan search(SubTask task, double unseenS, double sinceS, boolean isBlind) {
    if (unseenS > GIVE_UP_S) {
      return abandoned(
          String.format(Locale.ROOT, "%s unseen for %.0f s", task.objectTypes(), unseenS));
    }
    boolean looksAround = isBlind || sinceS % (STRAIGHT_S + AROUND_S) > STRAIGHT_S;
    NavigationPoint point =
        looksAround
            ? NavigationPoint.at(Point.of(0.01, 0.0, 0.0)).turn(AROUND_RAD)
            : NavigationPoint.at(Point.of(2.0, 0.0, 0.0));
    return Plan.underWay(List.of(point.speed(task.speed())));
  }

  /** The object of a type; if it was mapped twice, the more certain entry. */
  private Optional<ObjectDescription> object(String type) {
    return surroundings.objects().stream()
        .filter(object -> object.objectType().equals(type))
        .min(Comparator.comparingDouble(SightState::sigmaM));
  }

  private static double sigmaM(ObjectDescription object) {
    return object.motion().sigma().map(Point::distance).orElse(Double.POSITIVE_INFINITY);
  }

  /** Place of the object of a type, on the planner's plane. */
  final Optional<Point> place(String type, StateInformation state) {
    return object(type).map(object -> surroundings.centre(object, state));
  }

  /** Places of all objects of a type, on the planner's plane. */
  final Stream<Point> places(String type, StateInformation state) {
    return surroundings.objects().stream()
        .filter(object -> object.objectType().equals(type))
        .map(object -> surroundings.centre(object, state));
  }

  /** Level unit vector along the task's first object, or along a hoop's normal: north, east. */
  final Optional<Point> axis(SubTask task, StateInformation state) {
    return task.objectTypes().stream()
        .findFirst()
        .flatMap(this::object)
        .flatMap(object -> headingRad(object, state))
        .map(heading -> Point.of(Math.cos(heading), Math.sin(heading), 0.0));
  }

  private static Optional<Double> headingRad(ObjectDescription object, StateInformation state) {
    double psi;
    if (object instanceof Rectangle flat) {
      psi = flat.psi();
    } else if (object instanceof Hoop hoop) {
      psi = hoop.psi();
    } else {
      return Optional.empty();
    }
    if (object.referenceFrame().equals(ReferenceFrame.BODY)) {
      return Optional.of(state.psi().orElse(0.0) - psi); // positive to the left
    }
    return Optional.of(
        object.referenceFrame().equals(ReferenceFrame.LOCAL_ENU) ? Math.PI / 2.0 - psi : psi);
  }

  /** An axis or its opposite, whichever is closer to a direction. */
  static Point towards(Point axis, Point way) {
    return axis.x() * way.x() + axis.y() * way.y() < 0.0 ? axis.times(-1.0) : axis;
  }

  /** Moves straight to a point, facing it. The vector from the vehicle is north, east, down [m]. */
  final Plan to(SubTask task, StateInformation state, Point way) {
    Point place = surroundings.here(state).plus(way);
    NavigationPoint point = surroundings.straight(state, place).speed(task.speed());
    if (Math.hypot(way.x(), way.y()) > FACED_M) {
      point.turn(turnTo(way, state));
    }
    return Plan.underWay(List.of(point));
  }

  /** Turn after which the vehicle and its camera face a direction; positive to the right [rad]. */
  static double turnTo(Point way, StateInformation state) {
    double bearing = Math.atan2(way.y(), way.x());
    return Math.IEEEremainder(bearing - state.psi().orElse(0.0), 2.0 * Math.PI);
  }

  private static Plan abandoned(String reason) {
    return new Plan(List.of(), Plan.Progress.ABANDONED, "abandoned: " + reason);
  }

  static Plan completed(String remark) {
    return new Plan(List.of(), Plan.Progress.COMPLETED, remark);
  }
}
