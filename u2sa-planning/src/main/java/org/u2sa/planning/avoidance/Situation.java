package org.u2sa.planning.avoidance;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.avoidance.Avoidance.Wanted;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.guidance.LineSettings;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.MotionLimits;
import org.u2sa.planning.search.BodyDiscs;

/**
 * Input of one step of {@link Avoidance}. Immutable.
 *
 * @param pose pose of the vehicle on the planning plane; an aircraft's heading is its course
 * @param goalNorthM north coordinate of the goal on the plane [m]
 * @param goalEastM east coordinate of the goal on the plane [m]
 * @param heightM height difference to the goal [m]; 0 if unknown
 * @param goalHeadingRad required heading at the goal [rad]; empty: any
 * @param thresholdM distance at which the goal is reached [m]
 * @param limits limits of the motion
 * @param cellM edge of a cell of the cost grid [m]
 * @param body shape of the vehicle
 * @param slowRadiusM turn radius at planned speed [m]; 0 if the vehicle turns in place
 * @param settings settings of this step
 * @param micros time of the pose [µs]
 */
record Situation(
    Pose pose,
    double goalNorthM,
    double goalEastM,
    double heightM,
    OptionalDouble goalHeadingRad,
    double thresholdM,
    MotionLimits limits,
    double cellM,
    BodyDiscs body,
    double slowRadiusM,
    AvoidanceVariables settings,
    long micros) {
  private static final double PROGRESS_CELLS = 2.0;

  /** Fraction of its speed below which a vehicle that cannot stop or hover has not taken off. */
  private static final double SHARE_FLYING = 0.5;

  /**
   * @param toGoal vector to the goal: north, east, down [m]
   * @param cellM edge of a cell of the cost grid [m]
   */
  static Situation of(
      Pose pose,
      Point toGoal,
      Wanted wanted,
      Vehicle vehicle,
      double cellM,
      AvoidanceVariables now,
      LineSettings lines) {
    double slowRadiusM = turnRadiusM(now, lines, 0.0);
    return new Situation(
        pose,
        pose.northM() + toGoal.x(),
        pose.eastM() + toGoal.y(),
        Double.isNaN(toGoal.z()) ? 0.0 : Math.abs(toGoal.z()),
        wanted.headingRad(),
        wanted.thresholdM(),
        limits(vehicle, wanted, now, lines, cellM),
        cellM,
        now.body(slowRadiusM == 0.0),
        slowRadiusM,
        now,
        vehicle.timestampMicros());
  }

  static MotionLimits limits(
      Vehicle vehicle, Wanted wanted, AvoidanceVariables now, LineSettings lines, double cellM) {
    double wantedMps = wantedMps(wanted, now);
    // Wind adds to an aircraft's speed: plan with its ground speed.
    boolean drifts = !now.stops() && vehicle.speedMps() > SHARE_FLYING * wantedMps;
    return new MotionLimits(
        drifts ? vehicle.speedMps() : wantedMps,
        now.plannedAcceleration(),
        now.plannedBraking(),
        turnRadiusM(now, lines, vehicle.speedMps()),
        now.stops(),
        now.backwardsMps(),
        lines.lookAheadM(vehicle.speedMps()),
        now.touchM(cellM),
        now.preferredClearance(),
        now.trafficClearance(),
        now.trafficHorizon(),
        now.reactionTime(),
        Math.toRadians(now.plannedTurnRate()),
        now.clearance());
  }

  /** Desired speed of the vehicle; airspeed for aircraft [m/s]. */
  static double wantedMps(Wanted wanted, AvoidanceVariables now) {
    return Math.max(now.minSpeed(), wanted.speedMps().orElse(now.plannedSpeed()));
  }

  /** Minimum turn radius at a speed, at least the planned one [m]; 0 if it turns in place. */
  static double turnRadiusM(AvoidanceVariables now, LineSettings lines, double speedMps) {
    double speed = Math.max(speedMps, Math.max(now.plannedSpeed(), now.minSpeed()));
    return now.turnRadius() > 0.0 ? now.turnRadius() : lines.turns().radiusM(speed);
  }

  /** Smaller movements do not count as progress [m]. */
  double progressM() {
    return PROGRESS_CELLS * cellM;
  }
}
