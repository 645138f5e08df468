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
 * Room a vehicle needs to stop or turn round: its stopping distance with the drift until it holds
 * its position, or the region it may cover while turning.
 *
 * @param turns whether it turns; otherwise it brakes
 * @param reactionS delay from the failsafe until it brakes or turns [s]; until then it goes
 *     straight
 * @param brakingMps2 deceleration [m/s²]
 * @param bankRad bank angle in turns [rad]
 * @param leastRadiusM minimum turn radius [m], if it holds on a wide circle
 * @param windMps speed at which wind and current may carry it [m/s]
 * @param verticalMps2 vertical acceleration that ends a climb or descent [m/s²]
 * @param driftS time after braking until it holds against wind and current [s]
 */
record Manoeuvre(
    boolean turns,
    double reactionS,
    double brakingMps2,
    double bankRad,
    double leastRadiusM,
    double windMps,
    double verticalMps2,
    double driftS) {
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
        settings.verticalAcceleration(),
        settings.driftTime());
  }

  /**
   * Copy for a vehicle that is seen to drift faster than its wind allowance; one that turns, or has
   * no allowance because it holds wherever it stops, stays the same.
   */
  Manoeuvre driftingAt(double measuredMps) {
    return turns || windMps == 0.0 || measuredMps <= windMps
        ? this
        : new Manoeuvre(
            false,
            reactionS,
            brakingMps2,
            bankRad,
            leastRadiusM,
            measuredMps,
            verticalMps2,
            driftS);
  }

  /** Braking distance [m]: v²/2a. */
  double stoppingM(double speedMps) {
    return speedMps * speedMps / (2.0 * brakingMps2);
  }

  /** Distance until it holds its position [m]: reaction, braking and drift. */
  double wayToStopM(double speedMps) {
    return speedMps * reactionS + stoppingM(speedMps) + driftM(speedMps);
  }

  /** Turn radius in the air [m]: v²/(g tan φ), at its maximum possible airspeed. */
  double turnRadiusM(double speedMps) {
    double fastest = speedMps + windMps;
    return Math.max(leastRadiusM, fastest * fastest / lateralMps2());
  }

  /**
   * Maximum drift while it turns round, or while it brakes and until it holds its position [m]. A
   * vehicle that is carried towards the fence moves at least that fast, unless it already holds
   * against the drift.
   */
  double driftM(double speedMps) {
    if (!turns) {
      return Math.min(windMps, speedMps) * (speedMps / brakingMps2 + driftS);
    }
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
        : straight + stoppingM(speedMps) + cornersM(driftM(speedMps));
  }

  /** Radius of the polygon that approximates the turning circle, including drift [m]. */
  private double aroundM(double speedMps) {
    return cornersM(turnRadiusM(speedMps) + driftM(speedMps));
  }

  /** Radius of a polygon's corners around an arc [m]. */
  private static double cornersM(double radiusM) {
    return radiusM / Math.cos(Math.PI / (2.0 * ARC_CORNERS)); // corners lie outside the arc
  }

  /**
   * Region that the vehicle may cover until it has stopped or turned around to either side: for a
   * turn, the hull of both half circles ahead, extended by the wind drift; for a stop, the line to
   * it, and the half circle ahead of its end over which it may drift. What carries it back is not
   * covered: stopping does not prevent that, and it must be able to leave a fence.
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
      return stop(here, east, north, straight + stoppingM(speed), cornersM(driftM(speed)));
    }
    List<Coordinate> corners = new ArrayList<>(List.of(here));
    addTurn(corners, 1.0, here, east, north, speed);
    addTurn(corners, -1.0, here, east, north, speed);
    return hull(corners);
  }

  private static Geometry stop(
      Coordinate here, double east, double north, double aheadM, double driftM) {
    if (driftM == 0.0) {
      return GEOMETRY.createLineString(new Coordinate[] {here, at(here, east, north, aheadM, 0.0)});
    }
    List<Coordinate> corners = new ArrayList<>(List.of(here));
    for (int i = 0; i <= ARC_CORNERS; i++) {
      double angle = Math.PI * i / ARC_CORNERS;
      double ahead = aheadM + driftM * Math.sin(angle);
      corners.add(at(here, east, north, ahead, driftM * Math.cos(angle)));
    }
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
