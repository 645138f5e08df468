package org.u2sa.planning.survey;

import org.u2sa.planning.curve.Pose;

/**
 * A straight lane over cells that were not seen, on the planning plane.
 *
 * @param northM start: north [m]
 * @param eastM start: east [m]
 * @param courseRad direction [rad, clockwise from north]
 * @param lengthM length [m]
 * @param cells the cells that it covers
 */
record Lane(double northM, double eastM, double courseRad, double lengthM, int[] cells) {
  /** The same lane in the other direction. */
  Lane reversed() {
    return new Lane(northAt(lengthM), eastAt(lengthM), courseRad + Math.PI, lengthM, cells);
  }

  /** Start of the straight way before it. */
  Pose entry(double leadInM) {
    return new Pose(northAt(-leadInM), eastAt(-leadInM), courseRad);
  }

  Pose end() {
    return new Pose(northAt(lengthM), eastAt(lengthM), courseRad);
  }

  double northAt(double alongM) {
    return northM + alongM * Math.cos(courseRad);
  }

  double eastAt(double alongM) {
    return eastM + alongM * Math.sin(courseRad);
  }

  /** Distance along the lane from its start [m]. */
  double alongM(double north, double east) {
    return (north - northM) * Math.cos(courseRad) + (east - eastM) * Math.sin(courseRad);
  }

  /** Distance from the lane's line, right positive [m]. */
  double acrossM(double north, double east) {
    return (east - eastM) * Math.cos(courseRad) - (north - northM) * Math.sin(courseRad);
  }
}
