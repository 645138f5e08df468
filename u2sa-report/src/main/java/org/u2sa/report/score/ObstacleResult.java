package org.u2sa.report.score;

import java.util.List;
import java.util.Locale;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;

/**
 * Closest approach of a vehicle to an object, by ground truth.
 *
 * @param name UID of the object
 * @param moves whether it moves
 * @param leastM minimum distance of the vehicle's reference point from it [m]; 0 inside
 * @param timeS simulated time of that moment [s]
 * @param touched whether the vehicle, given its extent, touched or entered it
 */
public record ObstacleResult(
    String name, boolean moves, double leastM, double timeS, boolean touched) {

  /** Closest approach of a run to an object. The start of the run is the origin of local frames. */
  static ObstacleResult of(
      ObjectDescription object, Surroundings all, Geodetic home, List<TrackSample> track) {
    double least = Double.POSITIVE_INFINITY;
    double timeS = 0.0;
    for (TrackSample sample : track) {
      double away =
          all.distanceM(object, sample.timeS(), Surroundings.in(object, sample.place(), home));
      if (away < least) {
        least = away;
        timeS = sample.timeS();
      }
    }
    return new ObstacleResult(
        object.uid(), Surroundings.moves(object), least, timeS, least <= all.reachM());
  }

  String violation() {
    return String.format(Locale.ROOT, "entered %s at %.1f s, %.1f m from it", name, timeS, leastM);
  }
}
