package org.u2sa.planning.local;

import java.util.List;
import org.u2sa.planning.route.Route;

/**
 * Progress of a vehicle along its route. Progress is monotonic and does not pass a cusp of the
 * route until the vehicle has reached it. Not thread-safe.
 */
public final class RouteTrack {
  /** Search range ahead of the last position, in look-aheads. */
  private static final double SEARCHED = 3.0;

  private static final double REACHED = 0.25; // of a leg, which counts as its end

  private final double[] north;
  private final double[] east;
  private final boolean[] backwards; // to each point
  private final double[] at; // distance from the start [m]
  private final double cost;
  private double alongM;
  private int segment = 1; // end point of the vehicle's current segment

  public RouteTrack(Route route) {
    List<Route.Point> points = route.points();
    int count = Math.max(2, points.size());
    north = new double[count];
    east = new double[count];
    backwards = new boolean[count];
    at = new double[count];
    for (int i = 0; i < count; i++) {
      Route.Point point = points.get(Math.min(i, points.size() - 1));
      north[i] = point.northM();
      east[i] = point.eastM();
      backwards[i] = point.backwards();
      at[i] = i == 0 ? 0.0 : at[i - 1] + Math.hypot(north[i] - north[i - 1], east[i] - east[i - 1]);
    }
    cost = route.cost();
  }

  /** Cost of the whole route by the planner [m]. */
  public double cost() {
    return cost;
  }

  public int count() {
    return north.length;
  }

  /** North of a point [m]. */
  public double northM(int point) {
    return north[point];
  }

  /** East of a point [m]. */
  public double eastM(int point) {
    return east[point];
  }

  public boolean goesBackwards() {
    return backwards[segment];
  }

  /** Remaining length [m]. */
  public double remainingM() {
    return at[at.length - 1] - alongM;
  }

  /**
   * Updates with the vehicle's position.
   *
   * @param reachedM distance within which a cusp counts as reached [m], or a quarter of the leg
   * @return distance off the route [m]
   */
  public double follow(double vehicleNorth, double vehicleEast, double reachedM, double aheadM) {
    int cusp = cusp();
    double best = Double.POSITIVE_INFINITY;
    double bestAt = alongM;
    int bestSegment = segment;
    for (int i = segment; i <= cusp && at[i - 1] <= alongM + SEARCHED * aheadM; i++) {
      double dn = north[i] - north[i - 1];
      double de = east[i] - east[i - 1];
      double length = at[i] - at[i - 1];
      double share =
          length == 0.0
              ? 0.0
              : ((vehicleNorth - north[i - 1]) * dn + (vehicleEast - east[i - 1]) * de)
                  / (length * length);
      double bounded = Math.max(0.0, Math.min(1.0, share));
      double along = Math.max(alongM, at[i - 1] + bounded * length);
      double back = length == 0.0 ? 0.0 : (along - at[i - 1]) / length;
      double away =
          Math.hypot(
              vehicleNorth - north[i - 1] - back * dn, vehicleEast - east[i - 1] - back * de);
      if (away < best - 1.0e-9) {
        best = away;
        bestAt = along;
        bestSegment = i;
      }
    }
    alongM = bestAt;
    segment = bestSegment;
    if (at[cusp] - alongM <= within(reachedM) && cusp < at.length - 1) {
      alongM = at[cusp];
      segment = cusp + 1;
    }
    return best;
  }

  /** Whether the vehicle is at the end of its last leg; parameter as in {@link #follow}. */
  public boolean isAtEnd(double reachedM) {
    return remainingM() <= within(reachedM);
  }

  private double within(double reachedM) {
    return Math.min(reachedM, REACHED * legM());
  }

  /** Length of the current leg, between cusps [m]. */
  double legM() {
    int first = segment - 1;
    while (first > 0 && backwards[first] == backwards[segment]) {
      first--;
    }
    return at[cusp()] - at[first];
  }

  /** Next cusp, or the last point. */
  private int cusp() {
    int i = segment;
    while (i + 1 < at.length && backwards[i + 1] == backwards[segment]) {
      i++;
    }
    return i;
  }

  /** North coordinate at a distance ahead, not beyond a cusp [m]. */
  public double northAheadM(double metres) {
    return ahead(north, metres);
  }

  /** East coordinate at a distance ahead, not beyond a cusp [m]. */
  public double eastAheadM(double metres) {
    return ahead(east, metres);
  }

  private double ahead(double[] values, double metres) {
    int cusp = cusp();
    double wanted = Math.min(alongM + metres, at[cusp]);
    int i = segment;
    while (i < cusp && at[i] < wanted) {
      i++;
    }
    double length = at[i] - at[i - 1];
    double share = length == 0.0 ? 1.0 : Math.min(1.0, (wanted - at[i - 1]) / length);
    return values[i - 1] + share * (values[i] - values[i - 1]);
  }

  /** Next point not yet passed. */
  public int next() {
    return segment;
  }
}
