package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.algorithm.ConvexHull;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.FailsafeAction;

/**
 * Room a vehicle needs to stop or turn round: its stopping distance, or the region it may cover
 * while turning.
 *
 * @param turns whether it turns; otherwise it brakes
 * @param reactionS delay from the failsafe until it brakes or turns [s]; until then it goes
 *     straight
 * @param brakingMps2 deceleration [m/s²]
 * @param bankRad bank angle in turns [rad]
 * @param leastRadiusM minimum turn radius [m], if it holds on a wide circle
 * @param windMps wind that may drift it during a turn [m/s]
 * @param verticalMps2 vertical acceleration that ends a climb or descent [m/s²]
 */
record Manoeuvre(
    boolean turns,
    double reactionS,
    double brakingMps2,
    double bankRad,
    double leastRadiusM,
    double windMps,
    double verticalMps2) {
  /** Values of FENCE MANOEUVRE. */
  static final String BRAKE = "BRAKE";

  static final String TURN_TO_ONE_SIDE = "TURN TO ONE SIDE";

  private static final double SLOWEST_MPS = 0.1;
  private static final int ARC_CORNERS = 12;
  private static final GeometryFactory GEOMETRY = new GeometryFactory();

  /**
   * Creates the configured manoeuvre; room for the holding circle is needed only if the fence
   * action is to hold.
   */
  static Manoeuvre of(SafetyVariables settings, FailsafeAction onFence) {
    return new Manoeuvre(
        !settings.fenceManoeuvre().equals(BRAKE),
        settings.reactionTime(),
        settings.braking(),
        settings.turnBank(),
        onFence == FailsafeAction.HOLD ? settings.holdRadius() : 0.0,
        settings.windAllowance(),
        settings.verticalAcceleration());
  }

  /** Braking distance [m]: v²/2a. */
  double stoppingM(double speedMps) {
    return speedMps * speedMps / (2.0 * brakingMps2);
  }

  /** Turn radius in the air [m]: v²/(g tan φ), at its maximum possible airspeed. */
  double turnRadiusM(double speedMps) {
    double fastest = speedMps + windMps;
    return Math.max(leastRadiusM, fastest * fastest / lateralMps2());
  }

  /** Maximum wind drift while it turns round [m], in any direction. */
  double driftM(double speedMps) {
    double halfTurnS = Math.PI * turnRadiusM(speedMps) / Math.max(SLOWEST_MPS, speedMps + windMps);
    return windMps * halfTurnS;
  }

  private double lateralMps2() {
    return Gravity.STANDARD_MPS2 * Math.tan(bankRad);
  }

  /** Altitude change until a climb or descent has ended [m], signed. */
  double overshootM(double upMps) {
    return upMps * reactionS + Math.signum(upMps) * upMps * upMps / (2.0 * verticalMps2);
  }

  /** Upper bound of the distance to any point of its {@link #region} [m]. */
  double reachM(double speedMps) {
    if (speedMps < SLOWEST_MPS) {
      return 0.0;
    }
    double straight = speedMps * reactionS;
    return turns
        ? Math.hypot(straight + aroundM(speedMps), turnRadiusM(speedMps) + aroundM(speedMps))
        : straight + stoppingM(speedMps);
  }

  /** Radius of the polygon that approximates the turning circle, including drift [m]. */
  private double aroundM(double speedMps) {
    double inside = turnRadiusM(speedMps) + driftM(speedMps);
    return inside / Math.cos(Math.PI / (2.0 * ARC_CORNERS)); // corners lie outside the arc
  }

  /**
   * Region that the vehicle may cover until it has stopped or turned around to either side: for a
   * turn, the hull of both half circles ahead, extended by the wind drift.
   *
   * @param place east and north [m]
   * @param velocity east and north [m/s]
   */
  Geometry region(Point place, Point velocity) {
    Coordinate here = new Coordinate(place.x(), place.y());
    double speed = Math.hypot(velocity.x(), velocity.y());
    if (speed < SLOWEST_MPS) {
      return GEOMETRY.createPoint(here);
    }
    double east = velocity.x() / speed;
    double north = velocity.y() / speed;
    double straight = speed * reactionS;
    if (!turns) {
      double ahead = straight + stoppingM(speed);
      return GEOMETRY.createLineString(
          new Coordinate[] {here, new Coordinate(here.x + ahead * east, here.y + ahead * north)});
    }
    List<Coordinate> corners = new ArrayList<>(List.of(here));
    addTurn(corners, 1.0, here, east, north, speed);
    addTurn(corners, -1.0, here, east, north, speed);
    return hull(corners);
  }

  /**
   * Region that the vehicle may cover until it has turned around to one side.
   *
   * @param side 1: right, -1: left
   */
  Geometry regionToOneSide(Point place, Point velocity, double side) {
    double speed = Math.hypot(velocity.x(), velocity.y());
    if (speed < SLOWEST_MPS) {
      return region(place, velocity);
    }
    Coordinate here = new Coordinate(place.x(), place.y());
    List<Coordinate> corners = new ArrayList<>(List.of(here));
    addTurn(corners, side, here, velocity.x() / speed, velocity.y() / speed, speed);
    return hull(corners);
  }

  private void addTurn(
      List<Coordinate> corners,
      double side,
      Coordinate here,
      double east,
      double north,
      double speed) {
    double straight = speed * reactionS;
    double radius = turnRadiusM(speed);
    double around = aroundM(speed);
    for (int i = 0; i <= ARC_CORNERS; i++) {
      double angle = Math.PI * i / ARC_CORNERS;
      double ahead = straight + around * Math.sin(angle);
      corners.add(at(here, east, north, ahead, side * (radius + around * Math.cos(angle))));
    }
    double behind = straight - driftM(speed);
    corners.add(at(here, east, north, behind, side * (radius + around)));
    corners.add(at(here, east, north, behind, side * (radius - around)));
  }

  private static Geometry hull(List<Coordinate> corners) {
    return new ConvexHull(corners.toArray(new Coordinate[0]), GEOMETRY).getConvexHull();
  }

  private static Coordinate at(
      Coordinate here, double east, double north, double ahead, double aside) {
    return new Coordinate(
        here.x + ahead * east + aside * north, here.y + ahead * north - aside * east);
  }
}
