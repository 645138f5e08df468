package org.u2sa.planning.avoidance;

import java.util.OptionalDouble;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.MotionLimits;
import org.u2sa.planning.search.BodyDiscs;

/**
 * Input of one step of {@link Avoidance}. Immutable.
 *
 * @param pose pose of the vehicle on the planning plane; an aircraft's heading is its course
 * @param goalNorthM north coordinate of the goal on the plane [m]
 * @param goalEastM east coordinate of the goal on the plane [m]
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
    OptionalDouble goalHeadingRad,
    double thresholdM,
    MotionLimits limits,
    double cellM,
    BodyDiscs body,
    double slowRadiusM,
    AvoidanceVariables settings,
    long micros) {
  private static final double PROGRESS_CELLS = 2.0;

  /** Smaller movements do not count as progress [m]. */
  double progressM() {
    return PROGRESS_CELLS * cellM;
  }
}
