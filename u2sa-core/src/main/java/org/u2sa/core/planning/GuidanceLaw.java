package org.u2sa.core.planning;

import java.util.function.DoubleSupplier;
import org.u2sa.messages.frame.Point;

/**
 * How a vehicle is led onto a line and along it. A law of your own comes by a {@link
 * GuidanceLawProvider}.
 */
public interface GuidanceLaw {
  /**
   * The point to go to now: north, east [m] from the vehicle, z 0.
   *
   * @param leg with the vehicle at the origin; not a point
   * @param lookAheadM how far ahead the point is to lie [m], positive
   */
  Point pointAhead(Leg leg, double lookAheadM);

  /**
   * Leads to a point on the line, the look-ahead ahead of the vehicle's foot on it (after Park,
   * Deyst, How: A New Nonlinear Guidance Logic for Trajectory Tracking, AIAA 2004-4900).
   */
  static GuidanceLaw carrot() {
    return (leg, lookAheadM) -> {
      double along = leg.alongM(0.0, 0.0) + lookAheadM;
      return Point.of(leg.northAtM(along), leg.eastAtM(along), 0.0);
    };
  }

  /**
   * Leads along a field of courses around the line: far off it, towards it at the intercept angle;
   * the nearer, the more along it (Nelson, Barber, McLain, Beard: Vector Field Path Following for
   * Miniature Air Vehicles, IEEE Transactions on Robotics 23(3), 2007, eq. 6).
   *
   * <p>Near the line it answers as {@link #carrot} does with the same look-ahead. Far off it keeps
   * some way along the leg, where a carrot is approached ever more squarely.
   *
   * @param interceptRad course relative to the line, far off it [rad], above 0, at most π/2
   */
  static GuidanceLaw vectorField(DoubleSupplier interceptRad) {
    return (leg, lookAheadM) -> {
      double intercept = interceptRad.getAsDouble();
      // χ = χq − χ∞ · 2/π · atan(k e), with k such that χ ≈ χq − e / look-ahead near the line
      double steepness = Math.PI / (2.0 * intercept * lookAheadM);
      double across = leg.acrossM(0.0, 0.0);
      double course = leg.bearingRad() - intercept * 2.0 / Math.PI * Math.atan(steepness * across);
      return Point.of(lookAheadM * Math.cos(course), lookAheadM * Math.sin(course), 0.0);
    };
  }
}
