package org.u2sa.core.planning.local;

import java.util.List;
import org.u2sa.core.planning.route.Route;

/**
 * How far along its route a vehicle has come. It comes forward only; where the route turns back on
 * itself it looks no farther until it has been there. Belongs to one thread.
 */
public final class RouteTrack {
  /** How far ahead of the last place the vehicle is looked for, in look-aheads. */
  private static final double SEARCHED = 3.0;

  private final double[] north;
  private final double[] east;
  private final boolean[] backwards; // to each point
  private final double[] at; // way from the start [m]
  private final double cost;
  private double alongM;
  private int segment = 1; // the end of the one on which the vehicle is

  /** A track along a route that exists. */
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

  /** What the planner said that the whole route costs [m]. */
  public double cost() {
    return cost;
  }

  /** How many points it has. */
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

  /** Whether the vehicle goes backwards now. */
  public boolean goesBackwards() {
    return backwards[segment];
  }

  /** Way left [m]. */
  public double remainingM() {
    return at[at.length - 1] - alongM;
  }

  /** Way along the route so far [m]. */
  public double alongM() {
    return alongM;
  }

  /** Way to where the route turns back on itself, or to its end [m]. */
  public double straightOnM() {
    return at[cusp()] - alongM;
  }

  /**
   * Takes where the vehicle is.
   *
   * @param reachedM it has been at a turning point from this near on [m]
   * @return how far it is off the route [m]
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
    boolean there = at[cusp] - alongM <= reachedM;
    if (there && cusp < at.length - 1) {
      alongM = at[cusp];
      segment = cusp + 1;
    }
    return best;
  }

  /** The point at which the way turns back, or the last. */
  private int cusp() {
    int i = segment;
    while (i + 1 < at.length && backwards[i + 1] == backwards[segment]) {
      i++;
    }
    return i;
  }

  /** North of the place so far ahead, not beyond a turning point [m]. */
  public double northAheadM(double metres) {
    return ahead(north, metres);
  }

  /** East of the place so far ahead, not beyond a turning point [m]. */
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

  /** The next point that the vehicle has not passed. */
  public int next() {
    return segment;
  }
}
