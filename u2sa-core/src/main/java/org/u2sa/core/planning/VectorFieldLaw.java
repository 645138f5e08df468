package org.u2sa.core.planning;

import java.util.function.DoubleSupplier;
import org.u2sa.messages.frame.Point;

/**
 * Leads along a field of courses around the line: far off it, towards it at the intercept angle,
 * and the nearer the more along it (Nelson, Barber, McLain, Beard: Vector Field Path Following for
 * Miniature Air Vehicles, IEEE Transactions on Robotics 23(3), 2007, eq. 6).
 *
 * <p>Near the line it answers as {@link CarrotLaw} does with the same look-ahead. Far off it keeps
 * some way along the leg, where a carrot is approached ever more squarely.
 */
final class VectorFieldLaw implements LineLaw {
  private final DoubleSupplier interceptRad;

  /**
   * @param interceptRad course relative to the line, far off it [rad], 0…π/2 exclusive of 0
   */
  VectorFieldLaw(DoubleSupplier interceptRad) {
    this.interceptRad = interceptRad;
  }

  @Override
  public Point pointAhead(Leg leg, double lookAheadM) {
    double intercept = interceptRad.getAsDouble();
    // χ = χq − χ∞ · 2/π · atan(k e), with k such that χ ≈ χq − e / look-ahead near the line
    double steepness = Math.PI / (2.0 * intercept * lookAheadM);
    double across = leg.acrossM(0.0, 0.0);
    double course = leg.bearingRad() - intercept * 2.0 / Math.PI * Math.atan(steepness * across);
    return Point.of(lookAheadM * Math.cos(course), lookAheadM * Math.sin(course), 0.0);
  }
}
