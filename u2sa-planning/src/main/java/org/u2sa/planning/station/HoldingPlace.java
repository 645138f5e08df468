package org.u2sa.planning.station;

import java.util.function.Predicate;
import org.u2sa.planning.guidance.LoiterCircle;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Chooses where a vehicle that cannot stop circles when it holds: about its position, beside it, or
 * above.
 *
 * @param radiusM radius of the circle [m]
 * @param isClosed whether the vehicle must not fly at a place
 * @param isInside whether the fence leaves room to climb to a place
 */
public record HoldingPlace(double radiusM, Predicate<Place> isClosed, Predicate<Place> isInside) {
  private static final double[] HIGHER_M = {0.0, 25.0, 50.0, 100.0, 200.0};
  private static final double[] ASIDE = {0.0, 1.0, -1.0}; // to the right [radii]

  /**
   * Centre of the first circle that is closed along no part or, if there is none, along the
   * shortest.
   *
   * @param about where it would hold
   * @param aside whether the centre may be beside that
   */
  public Place near(Place about, boolean aside, Vehicle vehicle) {
    Place best = about;
    long least = Long.MAX_VALUE;
    for (double higherM : HIGHER_M) {
      for (double radii : ASIDE) {
        boolean isPossible = aside || radii == 0.0;
        Place centre = centre(about, radii * radiusM, higherM, vehicle.courseRad());
        if (!isPossible || higherM > 0.0 && !isInside.test(centre)) {
          continue;
        }
        long closed = new LoiterCircle(centre, radiusM, vehicle).closedDeg(isClosed);
        if (closed == 0) {
          return centre;
        }
        best = closed < least ? centre : best;
        least = Math.min(closed, least);
      }
    }
    return best;
  }

  private static Place centre(Place about, double rightM, double higherM, double courseRad) {
    Place level = about.moved(-rightM * Math.sin(courseRad), rightM * Math.cos(courseRad));
    return level.upM().isPresent() ? level.at(level.upM().getAsDouble() + higherM) : level;
  }
}
