package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.seen.PlanarShape;

/**
 * Marks to be passed on one side only, such as IGVC's flags or a channel's buoys: the other side of
 * each is blocked, across the approach, until the vehicle has passed. Confined to the planner's
 * thread.
 */
final class PassSides {
  /** Distance below which the route past a mark relies on seen objects on both sides [reaches]. */
  private static final double NEAR_REACHES = 1.8;

  /** Dead band of a mark's position [m]. */
  private static final double MOVED_M = 0.1;

  enum Side {
    LEFT(-1.0),
    RIGHT(1.0);

    private final double right;

    Side(double right) {
      this.right = right;
    }
  }

  private static final class Mark {
    final double courseRad;
    final Side side;
    double northM;
    double eastM;
    boolean isPassed;

    Mark(double courseRad, Side side) {
      this.courseRad = courseRad;
      this.side = side;
    }

    boolean moveTo(double north, double east) {
      if (Math.hypot(north - northM, east - eastM) <= MOVED_M) {
        return false;
      }
      northM = north;
      eastM = east;
      return !isPassed;
    }

    boolean isBehind(Pose pose, double marginM) {
      double ahead =
          (northM - pose.northM()) * Math.cos(courseRad)
              + (eastM - pose.eastM()) * Math.sin(courseRad);
      return ahead < -marginM;
    }

    PlanarShape closed(String name, double reachM) {
      double toNorth = side.right * Math.sin(courseRad);
      double toEast = -side.right * Math.cos(courseRad);
      double[] norths = {northM, northM + reachM * toNorth};
      double[] easts = {eastM, eastM + reachM * toEast};
      return PlanarShape.wall(name, norths, easts);
    }
  }

  private final Map<String, Mark> marks = new LinkedHashMap<>();
  private List<PlanarShape> closed = List.of();

  /**
   * Parses sides by object type from a text such as {@code red flag: LEFT, blue flag: RIGHT}.
   *
   * @throws IllegalArgumentException if an entry is invalid, naming it
   */
  static Map<String, Side> parse(String text) {
    Map<String, Side> sides = new LinkedHashMap<>();
    for (String entry : text.split(",")) {
      int colon = entry.lastIndexOf(':');
      if (entry.trim().isEmpty()) {
        continue;
      }
      String side = entry.substring(colon + 1).trim().toUpperCase(Locale.ROOT);
      if (colon < 1 || !side.equals("LEFT") && !side.equals("RIGHT")) {
        throw new IllegalArgumentException(
            "PASS SIDES: \""
                + entry.trim()
                + "\": expected a type and the side to pass on, such as red flag: LEFT");
      }
      sides.put(entry.substring(0, colon).trim(), Side.valueOf(side));
    }
    return sides;
  }

  List<PlanarShape> shapes() {
    return closed;
  }

  /** Resets, for example when the planning plane changes. */
  void forget() {
    marks.clear();
    closed = List.of();
  }

  /**
   * Updates with the marks seen now.
   *
   * @param seen marks by the side on which to pass them
   * @param pose pose of the vehicle
   * @param reachM length of the closure [m]
   * @param circleM turning radius of the vehicle [m]
   * @return whether {@link #shapes()} has changed
   */
  boolean see(
      Map<Side, List<PlanarShape>> seen,
      Pose pose,
      Optional<RouteTrack> route,
      double reachM,
      double circleM) {
    boolean changed = false;
    for (Map.Entry<Side, List<PlanarShape>> each : seen.entrySet()) {
      for (PlanarShape shape : each.getValue()) {
        double north = shape.northM(0);
        double east = shape.eastM(0);
        Mark mark = marks.get(shape.name());
        if (mark == null && pose.distanceM(north, east) <= NEAR_REACHES * reachM) {
          mark = new Mark(courseRad(pose, route, north, east), each.getKey());
          marks.put(shape.name(), mark);
        }
        if (mark != null) {
          changed |= mark.moveTo(north, east);
        }
      }
    }
    for (Mark mark : marks.values()) {
      boolean passes = !mark.isPassed && mark.isBehind(pose, circleM);
      mark.isPassed |= passes;
      changed |= passes;
    }
    if (changed) {
      List<PlanarShape> now = new ArrayList<>();
      marks.forEach(
          (name, mark) -> {
            if (!mark.isPassed) {
              now.add(mark.closed(name, reachM));
            }
          });
      closed = List.copyOf(now);
    }
    return changed;
  }

  /** Course of the route past a position; without a route, the vehicle's heading. */
  private static double courseRad(
      Pose pose, Optional<RouteTrack> route, double north, double east) {
    double course = pose.headingRad();
    double least = Double.POSITIVE_INFINITY;
    for (int i = 1; route.isPresent() && i < route.get().count(); i++) {
      double[] norths = {route.get().northM(i - 1), route.get().northM(i)};
      double[] easts = {route.get().eastM(i - 1), route.get().eastM(i)};
      PlanarShape leg = PlanarShape.wall("leg", norths, easts);
      double away = leg.distanceM(north, east);
      boolean leads = norths[0] != norths[1] || easts[0] != easts[1];
      if (leads && away < least) {
        least = away;
        course = Math.atan2(easts[1] - easts[0], norths[1] - norths[0]);
      }
    }
    return course;
  }
}
