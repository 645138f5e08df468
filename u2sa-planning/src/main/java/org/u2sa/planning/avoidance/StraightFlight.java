package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/** Checks straight ways of an aircraft for obstacles and traffic. */
final class StraightFlight {
  /** Height above the landing position below which obstacles are not checked [m]. */
  private static final double LOWEST_M = 2.0;

  /** Maximum distance checked, and length of a descent [m]: erroneous goals may be anywhere. */
  private static final double FARTHEST_M = 1.0e8;

  private static final double LONGEST_DESCENT_M = 1.0e5;

  private static final double CHECK_M = 0.5; // distance between positions of a checked way
  private static final double MAX_CORRIDOR_STEPS = 2000.0; // of a way inside corridors
  private static final double CLOSER_M = 0.1; // smaller approaches are free
  private static final double REACH_M = 300.0; // a way is checked so far ahead

  private final SeenWorld world;

  StraightFlight(SeenWorld world) {
    this.world = world;
  }

  /**
   * Whether a straight way leaves the corridors, one of which must always contain the vehicle; not
   * from a place that is outside them.
   *
   * @param from where it begins, on the planning plane [m]
   * @param way north and east from there [m]
   * @param stepM distance between checked positions, at least [m]
   */
  boolean leavesCorridors(Point from, Point way, double stepM) {
    if (world.corridors().isEmpty() || !isInCorridor(from.x(), from.y())) {
      return false;
    }
    double steps = Math.ceil(Math.min(Math.hypot(way.x(), way.y()), FARTHEST_M) / stepM);
    double most = Math.min(steps, MAX_CORRIDOR_STEPS);
    for (double i = 1.0; i <= most; i++) {
      if (!isInCorridor(from.x() + i / most * way.x(), from.y() + i / most * way.y())) {
        return true;
      }
    }
    return false;
  }

  private boolean isInCorridor(double north, double east) {
    return world.corridors().stream().anyMatch(each -> each.distanceM(north, east) == 0.0);
  }

  /**
   * Whether an obstacle is near the line to a position.
   *
   * @param at vehicle on the planning plane [m]
   */
  boolean isObstructed(
      Vehicle vehicle, Point at, Place to, BodyDiscs body, AvoidanceVariables now) {
    Point way = vehicle.nedOf(to);
    double keptM = body.circleM() + now.clearance();
    double lengthM = Math.hypot(way.x(), way.y());
    double steps = Math.ceil(lengthM / Math.max(1.0, 0.5 * keptM));
    double stepM = lengthM / steps;
    double last = Math.min(steps, Math.ceil(FARTHEST_M / stepM)); // NaN: at its target altitude
    for (PlanarShape shape : world.shapes()) {
      double i = 0.0;
      do {
        double share = steps == 0.0 ? 0.0 : i / steps;
        double away = shape.distanceM(at.x() + share * way.x(), at.y() + share * way.y());
        if (away < keptM) {
          return true;
        }
        i += Math.max(1.0, Math.floor((away - keptM) / stepM)); // nothing is closer up to there
      } while (i <= last);
    }
    return false;
  }

  /** Whether an obstacle is near a place on the planning plane [m], or no corridor contains it. */
  boolean isClosed(Point place, BodyDiscs body, AvoidanceVariables now) {
    double keptM = body.circleM() + now.clearance();
    return !world.corridors().isEmpty() && !isInCorridor(place.x(), place.y())
        || world.shapes().stream().anyMatch(shape -> shape.distanceM(place.x(), place.y()) < keptM);
  }

  /**
   * What a straight way leads into: it comes too close, and closer than the vehicle is.
   *
   * @param at vehicle on the planning plane [m]
   * @param way north and east to its end [m]
   * @return UID of the object; empty if the way is free
   */
  Optional<String> blocker(Point at, Point way, BodyDiscs body, AvoidanceVariables now) {
    double keptM = body.circleM() + now.touchM(world.costs().frame().cellM());
    return world.shapes().stream()
        .filter(shape -> isNeared(shape, at, way, keptM))
        .map(PlanarShape::name)
        .findFirst();
  }

  private static boolean isNeared(PlanarShape shape, Point at, Point way, double keptM) {
    double lengthM = Math.hypot(way.x(), way.y());
    double leastM = Math.min(keptM, shape.distanceM(at.x(), at.y()) - CLOSER_M);
    double alongM = 0.0;
    while (alongM < Math.min(lengthM, REACH_M)) {
      alongM += CHECK_M;
      double share = Math.min(1.0, alongM / lengthM);
      double awayM = shape.distanceM(at.x() + share * way.x(), at.y() + share * way.y());
      if (awayM < leastM) {
        return true;
      }
      alongM += Math.max(0.0, awayM - keptM - CHECK_M); // nothing is closer up to there
    }
    return false;
  }

  /** See {@link Avoidance#blocksDescent}; the vehicle on the planning plane [m]. */
  boolean blocksDescent(
      Vehicle vehicle, Point at, Place from, Place to, BodyDiscs body, AvoidanceVariables now) {
    Point end = vehicle.nedOf(to);
    Point way = end.minus(vehicle.nedOf(from));
    double circleM = body.circleM();
    double stepM = Math.max(1.0, 0.5 * circleM);
    List<PlanarShape> shapes = new ArrayList<>(world.shapes());
    shapes.addAll(world.shapesElsewhere());
    double lengthM = way.distance();
    double start = Math.min(1.0, LONGEST_DESCENT_M / lengthM);
    for (double share = start; share * way.z() > LOWEST_M; share -= stepM / lengthM) {
      double aboveM = share * way.z();
      double north = at.x() + end.x() - share * way.x();
      double east = at.y() + end.y() - share * way.y();
      double down = at.z() + end.z() - aboveM;
      for (PlanarShape shape : shapes) {
        boolean isAsHigh =
            now.verticalClearance() == 0.0
                || shape.reaches(down, down, Math.min(now.verticalClearance(), 0.5 * aboveM));
        double keptM = circleM + Math.min(now.clearance(), aboveM);
        if (isAsHigh && shape.distanceM(north, east) < keptM) {
          return true;
        }
      }
    }
    return false;
  }

  /** Whether traffic comes close within the horizon if the vehicle flies straight on. */
  boolean comesTraffic(Vehicle vehicle, Point at, BodyDiscs body, AvoidanceVariables now) {
    return TrafficHold.comesNear(
        world.movers(),
        vehicle,
        at,
        body.circleM() + 2.0 * now.trafficClearance(),
        now.trafficHorizon());
  }
}
