package org.u2sa.planning.local;

import java.util.Optional;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;

/**
 * Looks for a nearly straight way, ahead or in reverse, to where a vehicle can turn in place and
 * keeps its clearance, as astern of a boat in a dock. Immutable.
 */
final class RoomSearch {
  private static final int FAN = 6; // arcs to each side
  private static final double BEND = 0.5; // curvature of the outer ones, of the tightest
  private static final double REACH_RADII = 10.0; // length of the longest way
  private static final double MAX_TURN_RAD = Math.toRadians(60.0); // turn on an arc
  private static final double CLOSE = 10.0; // cost of each metre closer than the clearance [m]

  private final CostGrid costs;
  private final BodyDiscs body;
  private final MotionLimits limits;
  private final Pose pose;

  /**
   * A way to room.
   *
   * @param curvature [1/m], right positive
   * @param wayM length [m]
   * @param costM the same, more where it comes closer to obstacles than routes do [m]
   */
  record Way(boolean backwards, double curvature, double wayM, double costM) {}

  RoomSearch(CostGrid costs, BodyDiscs body, MotionLimits limits, Pose pose) {
    this.costs = costs;
    this.body = body;
    this.limits = limits;
    this.pose = pose;
  }

  /** The way of least cost in one direction; of equal ones, the straightest. */
  Optional<Way> best(boolean backwards) {
    Way best = null;
    for (int side = 0; side <= 2 * FAN; side++) {
      int k = (side % 2 == 0 ? 1 : -1) * ((side + 1) / 2); // straight first
      Way way = along(backwards, BEND * limits.tightest() * k / FAN);
      if (way != null && (best == null || way.costM() < best.costM() - costs.frame().cellM())) {
        best = way;
      }
    }
    return Optional.ofNullable(best);
  }

  /** The way along an arc; null if it leads to no room or over unseen ground in reverse. */
  private Way along(boolean backwards, double curvature) {
    double stepM = costs.frame().cellM();
    double reachM = Math.min(REACH_RADII * body.circleM(), MAX_TURN_RAD / Math.abs(curvature));
    double enoughM = TurnRoom.enoughM(costs, body, limits);
    double requiredM = Math.min(limits.touchM(), clearanceM(pose) - 1.0e-6);
    double leastM = limits.clearanceM();
    for (double gone = stepM; gone <= reachM; gone += stepM) {
      Pose at = pose.along(backwards ? -gone : gone, curvature);
      double clearance = clearanceM(at);
      boolean isUnseen =
          backwards && body.isRearUnseen(costs, at.northM(), at.eastM(), at.headingRad());
      if (clearance < requiredM || isUnseen) {
        return null;
      }
      leastM = Math.min(leastM, clearance);
      double turningM = costs.distanceM(at.northM(), at.eastM()) - body.circleM();
      if (turningM >= enoughM) {
        return new Way(backwards, curvature, gone, gone + CLOSE * (limits.clearanceM() - leastM));
      }
    }
    return null;
  }

  private double clearanceM(Pose at) {
    return body.clearanceM(costs, at.northM(), at.eastM(), at.headingRad(), limits.clearanceM());
  }
}
