package org.u2sa.planning.rightofway;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiConsumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.AvoidanceVariables;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.PlanningPlane;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Keeps right of way for a planner: reads other vessels from the perceived world, and converts
 * decisions to positions to go to. Confined to the planner's thread.
 */
public final class RightOfWayWatch {
  private static final String PLANNER = "RIGHT OF WAY";
  private static final double AHEAD_S = 900.0; // distance of the position to go to
  private static final double NEAR_SHARE = 0.5; // fraction left when a new point is set
  private static final double ON_MAP = 0.35; // fraction of the map, if routes are planned on one
  private static final double OPEN = 0.2; // fraction of the map that has to be free on a course

  private final Supplier<RightOfWayVariables> settings;
  private final Supplier<AvoidanceVariables> seeing;
  private final Supplier<LineSettings> lines;
  private final SeenWorld world;
  private final BiConsumer<String, String> remark; // receives part and words
  private final RightOfWay rules;
  private PlanningPlane plane;
  private CourseOrder manoeuvre; // of the last order; null if there was none
  private Point end; // position to go to: north, east
  private Optional<PlannedPath> news = Optional.empty();

  /**
   * A position to go to instead of the goal.
   *
   * @param place point far ahead on the course
   * @param speedMps speed [m/s]; 0: stop
   * @param isNew whether it differs from the last order
   */
  public record Order(Place place, double speedMps, boolean isNew) {}

  /**
   * @param say reports an encounter or a decision to the operator
   * @param remark sets a remark (part, words) in the planner's health report
   */
  public RightOfWayWatch(
      Supplier<RightOfWayVariables> settings,
      Supplier<AvoidanceVariables> seeing,
      Supplier<LineSettings> lines,
      SeenWorld world,
      BiConsumer<String, Boolean> say,
      BiConsumer<String, String> remark) {
    this.settings = settings;
    this.seeing = seeing;
    this.lines = lines;
    this.world = world;
    this.remark = remark;
    rules = new RightOfWay(settings, what -> say.accept(what, false));
  }

  public boolean isOn() {
    return settings.get().isOn();
  }

  /** Speed to a waypoint; required with right of way, because distances depend on it. */
  public OptionalDouble speed(OptionalDouble wanted) {
    return isOn() && wanted.isEmpty() ? OptionalDouble.of(seeing.get().plannedSpeed()) : wanted;
  }

  /** Changes for displays, once. */
  public Optional<PlannedPath> news() {
    Optional<PlannedPath> now = news;
    news = Optional.empty();
    return now;
  }

  /**
   * Decides.
   *
   * @param goal UID of the goal
   * @param toGoal vector to the goal, or to a position on the route to it: north, east [m]
   * @param speedMps speed at which to go there [m/s]
   * @return empty if the vehicle may go to its goal
   */
  public Optional<Order> order(
      Vehicle vehicle, StateInformation state, String goal, Point toGoal, double speedMps) {
    if (!isOn()) {
      return Optional.empty();
    }
    if (world.plane(state) != plane) {
      plane = world.plane(state);
      manoeuvre = null;
    }
    Point at = vehicle.on(plane);
    OwnShip own =
        new OwnShip(
            at.x(),
            at.y(),
            vehicle.northMps(),
            vehicle.eastMps(),
            Math.atan2(toGoal.y(), toGoal.x()),
            speedMps,
            limits(speedMps));
    long micros = vehicle.timestampMicros();
    List<Target> targets =
        world.traffic(state).stream()
            .map(mover -> Target.of(mover, micros))
            .collect(Collectors.toList());
    Optional<CourseOrder> decided =
        rules.decide(own, targets, course -> isOpen(own, course), Clock.seconds(micros));
    remark.accept("right of way", rules.remark());
    return decided.map(now -> order(now, own, at.z(), goal)).or(() -> none());
  }

  private Optional<Order> none() {
    manoeuvre = null;
    return Optional.empty();
  }

  private Order order(CourseOrder now, OwnShip own, double downM, String goal) {
    double speed = now.speedShare() * own.speedMps();
    boolean isNew =
        manoeuvre == null
            || now.courseRad() != manoeuvre.courseRad()
            || now.speedShare() != manoeuvre.speedShare();
    double reach = world.costs() == null ? AHEAD_S * own.speedMps() : ON_MAP * mapM(world.costs());
    boolean isNear =
        end != null
            && Math.hypot(end.x() - own.northM(), end.y() - own.eastM()) < NEAR_SHARE * reach;
    if (isNew || isNear) {
      end =
          Point.of(
              own.northM() + reach * Math.cos(now.courseRad()),
              own.eastM() + reach * Math.sin(now.courseRad()),
              downM);
    }
    Point place = plane.point(end.x(), end.y(), downM);
    if (isNew) {
      Point from = plane.point(own.northM(), own.eastM(), downM);
      news =
          Optional.of(
              new PlannedPath()
                  .goal(goal)
                  .planner(PLANNER)
                  .status(speed > 0.0 ? PathStatus.FOLLOWED : PathStatus.WAITING)
                  .referenceFrame(plane.frame())
                  .points(List.of(from, place))
                  .reason(now.toString()));
    }
    manoeuvre = now;
    return new Order(Place.of(plane.frame(), place), speed, isNew || isNear);
  }

  private OwnShip.Limits limits(double speedMps) {
    AvoidanceVariables now = seeing.get();
    double radius =
        now.turnRadius() > 0.0 ? now.turnRadius() : lines.get().turns().radiusM(speedMps);
    double rate = Math.toRadians(now.plannedTurnRate());
    return new OwnShip.Limits(
        Math.max(now.vehicleFront(), now.vehicleRear()),
        radius > 0.0 ? Math.min(rate, speedMps / radius) : rate,
        now.plannedBraking(),
        now.reactionTime(),
        now.minSpeed());
  }

  private static double mapM(CostGrid costs) {
    return costs.frame().rows() * costs.frame().cellM();
  }

  /** Whether no static obstacle on the map blocks a course nearby. */
  private boolean isOpen(OwnShip own, double courseRad) {
    CostGrid costs = world.costs();
    if (costs == null) {
      return true;
    }
    double reach = OPEN * mapM(costs);
    double north = own.northM() + reach * Math.cos(courseRad);
    double east = own.eastM() + reach * Math.sin(courseRad);
    return costs.straightCost(own.northM(), own.eastM(), north, east) < Double.POSITIVE_INFINITY;
  }
}
