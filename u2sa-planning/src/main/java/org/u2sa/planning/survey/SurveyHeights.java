package org.u2sa.planning.survey;

import java.util.Optional;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.seen.PlanningPlane;

/**
 * Altitudes at which an area is flown over: constant, or following a height map, no steeper than
 * the vehicle can climb.
 */
public final class SurveyHeights {
  private static final double REACH_M = 400.0; // ahead and behind
  private static final double STEP_M = 20.0;

  private final Optional<HeightGrid> terrain;

  /**
   * @param terrain the ground; empty: level, at the altitude given by the area
   */
  public SurveyHeights(Optional<HeightGrid> terrain) {
    this.terrain = terrain;
  }

  /** A point at flight altitude, in the frame of the plane. */
  public Point point(SearchArea area, SurveyVariables survey, PlanningPlane plane, Pose pose) {
    double altitude = altitudeM(area, survey, plane, pose);
    Point at = plane.point(pose.northM(), pose.eastM(), -altitude);
    return plane.onEarth() ? Point.of(at.x(), at.y(), altitude) : at;
  }

  /**
   * Flight altitude [m above mean sea level]: high enough for the limited climb from here, and
   * descent to here, along a straight line.
   */
  double altitudeM(SearchArea area, SurveyVariables survey, PlanningPlane plane, Pose pose) {
    double level = LaneLegs.altitudeM(area, survey);
    if (terrain.isEmpty() || !plane.onEarth()) {
      return level;
    }
    double heightM = level - area.ground();
    double halfM = 0.5 * heightM * survey.surveyPixels() / survey.surveyFocalLength();
    double altitude = Double.NEGATIVE_INFINITY;
    for (double along = -REACH_M; along <= REACH_M; along += STEP_M) {
      double ground = groundM(area, plane, pose, along, halfM);
      altitude = Math.max(altitude, ground + heightM - survey.surveyClimb() * Math.abs(along));
    }
    return Math.max(
        area.lowest().orElse(Double.NEGATIVE_INFINITY),
        Math.min(area.highest().orElse(Double.POSITIVE_INFINITY), altitude));
  }

  /** Middle between the highest and the lowest ground across a line [m]. */
  private double groundM(
      SearchArea area, PlanningPlane plane, Pose pose, double along, double halfM) {
    double lowest = Double.POSITIVE_INFINITY;
    double highest = Double.NEGATIVE_INFINITY;
    for (int side = -1; side <= 1; side++) {
      double cos = Math.cos(pose.headingRad());
      double sin = Math.sin(pose.headingRad());
      Point place =
          plane.point(
              pose.northM() + along * cos - side * halfM * sin,
              pose.eastM() + along * sin + side * halfM * cos,
              0.0);
      double ground =
          terrain.get().altitudeM(new Geodetic(place.x(), place.y(), 0.0)).orElse(area.ground());
      lowest = Math.min(lowest, ground);
      highest = Math.max(highest, ground);
    }
    return 0.5 * (lowest + highest);
  }
}
