package org.u2sa.planning.guidance;

import java.util.function.DoubleSupplier;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/**
 * Law that guides a vehicle onto a line and along it. Extensions supply their own through a {@link
 * GuidanceLawProvider}.
 */
public interface GuidanceLaw {
  /**
   * Target point: north, east [m] from the vehicle, z 0.
   *
   * @param leg leg with the vehicle at the origin; not a point
   * @param lookAheadM look-ahead distance [m], positive
   */
  Point pointAhead(Leg leg, double lookAheadM);

  /** Starts a new line: laws with memory are reset. */
  default void begin() {}

  /**
   * Advances time on a line, before {@link #pointAhead}.
   *
   * @param stepS time since the previous call on this line [s], above 0
   */
  default void advance(Leg leg, double lookAheadM, double stepS) {}

  /** Saves the memory of the current line for the planner that takes over. */
  default void handOver(HandOver state) {}

  /** Resumes the line of the previous planner; missing values are reset. */
  default void takeOver(HandOver state) {}

  /**
   * Law that aims at a point on the line, one look-ahead ahead of the vehicle's projection (after
   * Park, Deyst, How: A New Nonlinear Guidance Logic for Trajectory Tracking, AIAA 2004-4900).
   */
  static GuidanceLaw carrot() {
    return (leg, lookAheadM) -> {
      double along = leg.alongM(0.0, 0.0) + lookAheadM;
      return Point.of(leg.northAtM(along), leg.eastAtM(along), 0.0);
    };
  }

  /**
   * Vector-field law: far from the line, the course meets it at the intercept angle; closer, the
   * course bends along it (Nelson, Barber, McLain, Beard: Vector Field Path Following for Miniature
   * Air Vehicles, IEEE Transactions on Robotics 23(3), 2007, eq. 6).
   *
   * <p>Near the line it is equivalent to {@link #carrot} with the same look-ahead. Far off it still
   * advances along the leg, whereas a carrot law approaches the leg ever more perpendicularly.
   *
   * @param interceptRad course relative to the line when far off [rad], above 0, at most π/2
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
