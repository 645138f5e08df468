package org.u2sa.planning.local;

import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;

/**
 * Room that a ground vehicle, boat or submarine has to move without a route: straight or turning
 * where it is, or, if it cannot turn in place, on the arc to a point. Immutable; valid until the
 * world changes.
 *
 * @param grid distances from what stands, on the planning plane
 * @param at vehicle on the planning plane [m]
 * @param headingRad its heading
 * @param way north and east to where it would move [m]
 * @param touchM clearance that it keeps from what stands [m]
 * @param turnRadiusM its minimum turn radius [m]; 0 if it turns in place
 */
public record SurfaceRoom(
    CostGrid grid,
    BodyDiscs body,
    Point at,
    double headingRad,
    Point way,
    double touchM,
    double turnRadiusM) {
  private static final double ROUNDING_M = 1.0e-6;
  private static final double REACH_M = 300.0; // a way is checked so far ahead
  private static final double SOON_M = 1.0; // in which a vehicle that berths stops
  private static final double TURN_CHECKS = 12.0; // headings between the present one and the last

  /**
   * Whether the way leads too close to what stands, and closer than the vehicle is; always if it
   * touches something already. A vehicle that cannot turn in place circles to a point beside or
   * behind it.
   */
  public boolean isOccupied() {
    double leastM = leastM();
    return isCloser(REACH_M, headingRad, leastM)
        || isCloser(REACH_M, courseRad(), leastM)
        || turnRadiusM > 0.0 && isCloserOnArc(leastM);
  }

  /** Clearance at which the vehicle comes too close, and closer than it is [m]. */
  private double leastM() {
    return Math.max(0.0, Math.min(touchM, hereM() - ROUNDING_M));
  }

  /** Direction of the way [rad]. */
  private double courseRad() {
    return Math.atan2(way.y(), way.x());
  }

  /** Length of the way [m]. */
  public double wayM() {
    return Math.hypot(way.x(), way.y());
  }

  /** Component along the way of a vector to the north and east; 0 if the way has no length. */
  public double alongWay(double north, double east) {
    return wayM() > 0.0 ? (north * way.x() + east * way.y()) / wayM() : 0.0;
  }

  /**
   * Distance along the way and straight on beyond its end until the vehicle comes too close to what
   * stands [m]; infinite if it does not.
   *
   * @param reachM distance that is checked
   */
  public double freeAlongWayM(double reachM) {
    double leastM = leastM();
    return Math.min(
        freeM(courseRad(), headingRad, reachM, leastM),
        freeM(courseRad(), courseRad(), reachM, leastM));
  }

  /** Likewise, straight on in any direction [rad], without turning. */
  public double freeM(double course, double reachM) {
    return freeM(course, headingRad, reachM, leastM());
  }

  /**
   * Distance along the way and straight on until the vehicle, without turning, runs into something
   * [m]; infinite if it does not, or touches something already, as in a narrow berth.
   */
  public double freeInBerthM(double reachM) {
    return hereM() < 0.0 ? Double.POSITIVE_INFINITY : freeM(courseRad(), headingRad, reachM, 0.0);
  }

  private double freeM(double course, double heading, double reachM, double limitM) {
    double stepM = grid.frame().cellM();
    for (double gone = stepM; gone <= Math.min(reachM, REACH_M); gone += stepM) {
      Point place =
          Point.of(at.x() + gone * Math.cos(course), at.y() + gone * Math.sin(course), at.z());
      if (clearanceM(place, heading) < limitM) {
        return gone - stepM;
      }
    }
    return Double.POSITIVE_INFINITY;
  }

  /**
   * Whether the vehicle would soon run into something without turning; never if it touches
   * something already, as in a narrow berth.
   */
  public boolean isBlockedSoon() {
    return hereM() >= 0.0 && isCloser(SOON_M, headingRad, 0.0);
  }

  /**
   * Whether the vehicle can turn where it is without running into something; always if it touches
   * something already.
   *
   * @param turnRad turn [rad], positive to the right
   */
  public boolean isEnoughToTurn(double turnRad) {
    boolean isFree = true;
    for (double k = 1.0; isFree && k <= TURN_CHECKS; k++) {
      isFree = clearanceM(at, headingRad + k / TURN_CHECKS * turnRad) >= 0.0;
    }
    return isFree || hereM() < 0.0;
  }

  /** Likewise, anywhere on the way. */
  public boolean isEnoughToTurnOnWay(double turnRad) {
    double leastM = leastM();
    for (double k = 1.0; k <= TURN_CHECKS; k++) {
      if (isCloser(REACH_M, headingRad + k / TURN_CHECKS * turnRad, leastM)) {
        return false;
      }
    }
    return true;
  }

  private double hereM() {
    return clearanceM(at, headingRad);
  }

  private double clearanceM(Point place, double heading) {
    return body.clearanceM(grid, place.x(), place.y(), heading);
  }

  /** Whether the clearance falls below a limit on a part of the way. */
  private boolean isCloser(double reachM, double heading, double limitM) {
    double lengthM = wayM();
    double steps = Math.ceil(Math.min(lengthM, reachM) / grid.frame().cellM());
    for (double i = 1.0; i <= steps; i++) {
      double share = i / steps * Math.min(1.0, reachM / lengthM);
      Point place = Point.of(at.x() + share * way.x(), at.y() + share * way.y(), at.z());
      if (clearanceM(place, heading) < limitM) {
        return true;
      }
    }
    return false;
  }

  /** Whether the clearance falls below a limit on the arc, at most a full circle longer. */
  private boolean isCloserOnArc(double limitM) {
    double north = at.x() + way.x();
    double east = at.y() + way.y();
    double stepM = grid.frame().cellM();
    double reachM = Math.min(wayM(), REACH_M) + 2.0 * Math.PI * turnRadiusM;
    Pose pose = new Pose(at.x(), at.y(), headingRad);
    double goneM = 0.0;
    while (goneM < reachM && pose.distanceM(north, east) > stepM) {
      goneM += stepM;
      pose = pose.along(stepM, pose.curvatureTo(north, east, 1.0 / turnRadiusM, false));
      if (body.clearanceM(grid, pose.northM(), pose.eastM(), pose.headingRad()) < limitM) {
        return true;
      }
    }
    return false;
  }
}
