package org.u2sa.gcs.mavlink.telemetry;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.schema.U2SAData;

/**
 * What the Path Planner follows: its path around obstacles, or else the line from the waypoint
 * before, or from where the vehicle was when it turned to its goal. {@link #take} may be called on
 * any thread.
 */
public final class FollowedRoute {
  /** Channels to subscribe to. */
  public static final List<Channel<?>> CHANNELS =
      List.of(Channels.GOALS, Channels.PLANS, Channels.NAVIGATION);

  private static final String VEHICLE = "VEHICLE"; // the subsystem
  private static final long FRESH_MICROS = 2_000_000;
  private static final double NEAR_SHARE = 0.1; // of a leg's length: still at its start
  private static final double SHORTEST_M = 0.1; // of what has a direction

  /**
   * @param start empty if the vehicle's position was unknown when it turned to the goal
   * @param end the goal's place
   */
  private record Leg(String goal, Optional<Geodetic> start, Geodetic end) {}

  private record Heard(NavigationPoint point, long micros) {}

  private final VehicleStatus vehicle;
  private final LongSupplier micros;
  private volatile Leg leg; // null: unknown
  private volatile PlannedPath path; // null until heard, like the next
  private volatile Heard navigation;

  /**
   * @param micros real time [µs]
   */
  public FollowedRoute(VehicleStatus vehicle, LongSupplier micros) {
    this.vehicle = vehicle;
    this.micros = micros;
  }

  /** Takes a message of any of {@link #CHANNELS}. */
  public void take(U2SAData message) {
    if (message instanceof GoalList list) {
      take(list);
    } else if (message instanceof PlannedPath planned && planned.subsystem().equals(VEHICLE)) {
      path = planned;
    } else if (message instanceof NavigationPoint point && point.subsystem().equals(VEHICLE)) {
      navigation = new Heard(point, micros.getAsLong());
    }
  }

  private void take(GoalList list) {
    Optional<Waypoint> goal =
        list.goals().stream()
            .findFirst()
            .filter(Waypoint.class::isInstance)
            .map(Waypoint.class::cast);
    Optional<Geodetic> end = goal.flatMap(Placement::place);
    Leg before = leg;
    if (end.isEmpty()) {
      leg = null;
    } else if (before == null
        || !before.goal().equals(goal.get().uid())
        || !before.end().equals(end.get())) {
      leg = new Leg(goal.get().uid(), start(before, end.get()), end.get());
    }
  }

  private Optional<Geodetic> start(Leg before, Geodetic end) {
    return vehicle
        .state()
        .flatMap(Placement::place)
        .map(
            here ->
                before != null && before.end().distanceM(here) < NEAR_SHARE * here.distanceM(end)
                    ? before.end()
                    : here);
  }

  /** Newest navigation point of the vehicle; empty if none arrived within 2 s. */
  Optional<NavigationPoint> navigation() {
    return Optional.ofNullable(navigation)
        .filter(heard -> micros.getAsLong() - heard.micros() <= FRESH_MICROS)
        .map(Heard::point);
  }

  /** The same in GLOBAL; empty if the state lacks position or heading. */
  Optional<Geodetic> next(StateInformation global) {
    if (global.x().isEmpty() || global.y().isEmpty() || global.psi().isEmpty()) {
      return Optional.empty();
    }
    return navigation()
        .filter(point -> !point.referenceFrame().isLocal())
        .map(point -> Geodetic.of(point.in(ReferenceFrame.GLOBAL, global).point()));
  }

  /**
   * Distance of the line from the vehicle [m], positive if the line is to its right as seen in the
   * direction of travel; empty if unknown.
   */
  OptionalDouble crossTrackErrorM(Geodetic here) {
    Leg now = leg;
    PlannedPath planned = path;
    if (now == null) {
      return OptionalDouble.empty();
    }
    boolean isOnPath =
        planned != null
            && planned.goal().equals(now.goal())
            && planned.status() == PathStatus.FOLLOWED
            && planned.referenceFrame().equals(ReferenceFrame.GLOBAL)
            && planned.points().size() > 1;
    if (!isOnPath) {
      if (now.start().isEmpty()) {
        leg = new Leg(now.goal(), Optional.of(here), now.end());
      }
      Point start = here.enuOf(now.start().orElse(here));
      Point end = here.enuOf(now.end());
      return isShort(start, end)
          ? OptionalDouble.empty()
          : OptionalDouble.of(rightwards(start, end));
    }
    return nearest(planned.points().stream().map(at -> here.enuOf(Geodetic.of(at))).toList());
  }

  private static boolean isShort(Point start, Point end) {
    return Math.hypot(end.x() - start.x(), end.y() - start.y()) < SHORTEST_M;
  }

  /** Of the part that is nearest to the origin. */
  private static OptionalDouble nearest(List<Point> corners) {
    OptionalDouble error = OptionalDouble.empty();
    double leastM = Double.POSITIVE_INFINITY;
    for (int i = 1; i < corners.size(); i++) {
      Point start = corners.get(i - 1);
      Point end = corners.get(i);
      double distanceM = distanceM(start, end);
      if (!isShort(start, end) && distanceM < leastM) {
        leastM = distanceM;
        error = OptionalDouble.of(rightwards(start, end));
      }
    }
    return error;
  }

  /** Distance of a line from the origin, to the right [m]; points are east and north of it. */
  private static double rightwards(Point start, Point end) {
    double east = end.x() - start.x();
    double north = end.y() - start.y();
    return (start.x() * north - start.y() * east) / Math.hypot(east, north);
  }

  private static double distanceM(Point start, Point end) {
    double east = end.x() - start.x();
    double north = end.y() - start.y();
    double square = east * east + north * north;
    double share =
        square == 0.0
            ? 0.0
            : Math.max(0.0, Math.min(1.0, -(start.x() * east + start.y() * north) / square));
    return Math.hypot(start.x() + share * east, start.y() + share * north);
  }
}
