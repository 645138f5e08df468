package org.u2sa.core.planning;

import org.u2sa.messages.frame.Point;

/**
 * Leads to a point on the line, the look-ahead ahead of the vehicle's foot on it (after Park,
 * Deyst, How: A New Nonlinear Guidance Logic for Trajectory Tracking, AIAA 2004-4900).
 */
final class CarrotLaw implements LineLaw {
  @Override
  public Point pointAhead(Leg leg, double lookAheadM) {
    double along = leg.alongM(0.0, 0.0) + lookAheadM;
    return Point.of(leg.northAtM(along), leg.eastAtM(along), 0.0);
  }
}
