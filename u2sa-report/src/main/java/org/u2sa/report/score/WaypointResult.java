package org.u2sa.report.score;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Result at one waypoint, by ground truth. All three numbers are empty if the waypoint was never
 * the target.
 *
 * @param waypoint planned waypoint
 * @param missM smallest horizontal distance to it while it was the target [m]
 * @param altitudeErrorM altitude error at that moment [m], too high positive; also empty if no
 *     altitude was planned
 * @param timeS simulated time of that moment [s]
 * @param captured whether, at some moment while it was the target, the vehicle was within the
 *     capture radius and the vertical threshold, if any
 */
public record WaypointResult(
    RunPlan.Waypoint waypoint,
    OptionalDouble missM,
    OptionalDouble altitudeErrorM,
    OptionalDouble timeS,
    boolean captured) {

  /**
   * Closest approach of a run to a waypoint while it was the target, see {@link TrackSample#leg()}.
   */
  static WaypointResult of(RunPlan.Waypoint waypoint, int leg, List<TrackSample> track) {
    Approach approach = new Approach(waypoint);
    for (int i = 0; i < track.size(); i++) {
      if (track.get(i).leg() == leg) {
        // including the sample at which the target changed: capture happens between the two
        approach.segment(track.get(i), track.get(Math.min(i + 1, track.size() - 1)));
      }
    }
    return approach.result();
  }

  private static final class Approach {
    private final RunPlan.Waypoint waypoint;
    private final PlotPlane plane;
    private double miss = Double.POSITIVE_INFINITY;
    private double altitude;
    private double time;
    private boolean captured;

    Approach(RunPlan.Waypoint waypoint) {
      this.waypoint = waypoint;
      plane = new PlotPlane(waypoint);
    }

    private void segment(TrackSample from, TrackSample to) {
      PlotPlane.Place a = plane.place(from);
      PlotPlane.Place b = plane.place(to);
      double dx = b.eastM() - a.eastM();
      double dy = b.northM() - a.northM();
      double lengthSquared = dx * dx + dy * dy;
      boolean isVertical = lengthSquared == 0.0;
      double foot = isVertical ? 0.0 : -(a.eastM() * dx + a.northM() * dy) / lengthSquared;
      // closest point, as a fraction of the segment from a to b
      double share = isVertical ? vertically(from.altitudeM(), to.altitudeM()) : clamp(foot);
      double distance = a.towards(b, share).distanceM();
      double height = between(from.altitudeM(), to.altitudeM(), share);
      if (distance < miss || distance == miss && offM(height) < offM(altitude)) {
        miss = distance;
        altitude = height;
        time = between(from.timeS(), to.timeS(), share);
      }
      double radius = waypoint.captureRadiusM();
      if (!captured && distance <= radius) {
        double beside = a.towards(b, foot).distanceM();
        double half =
            isVertical
                ? Double.POSITIVE_INFINITY
                : Math.sqrt((radius * radius - beside * beside) / lengthSquared);
        captured =
            withinVertically(
                between(from.altitudeM(), to.altitudeM(), clamp(foot - half)),
                between(from.altitudeM(), to.altitudeM(), clamp(foot + half)));
      }
    }

    /**
     * Fraction of the way between two altitudes that is closest to the waypoint's, if it has one.
     */
    private double vertically(double fromM, double toM) {
      return waypoint.altitudeM().isEmpty() || fromM == toM
          ? 0.0
          : clamp((waypoint.altitudeM().getAsDouble() - fromM) / (toM - fromM));
    }

    /** Distance of an altitude from the waypoint's; 0 if it has none. */
    private double offM(double altitudeM) {
      return waypoint.altitudeM().isEmpty()
          ? 0.0
          : Math.abs(altitudeM - waypoint.altitudeM().getAsDouble());
    }

    /** Whether an altitude between the two is within the vertical threshold. */
    private boolean withinVertically(double oneM, double otherM) {
      if (waypoint.altitudeM().isEmpty() || waypoint.verticalThresholdM().isEmpty()) {
        return true;
      }
      double wanted = waypoint.altitudeM().getAsDouble();
      double threshold = waypoint.verticalThresholdM().getAsDouble();
      return Math.min(oneM, otherM) <= wanted + threshold
          && Math.max(oneM, otherM) >= wanted - threshold;
    }

    private WaypointResult result() {
      if (Double.isInfinite(miss)) {
        return new WaypointResult(
            waypoint,
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            false);
      }
      OptionalDouble error =
          waypoint.altitudeM().isPresent()
              ? OptionalDouble.of(altitude - waypoint.altitudeM().getAsDouble())
              : OptionalDouble.empty();
      return new WaypointResult(
          waypoint, OptionalDouble.of(miss), error, OptionalDouble.of(time), captured);
    }

    private static double between(double from, double to, double share) {
      return from + share * (to - from);
    }

    private static double clamp(double share) {
      return Math.max(0.0, Math.min(1.0, share));
    }
  }
}
