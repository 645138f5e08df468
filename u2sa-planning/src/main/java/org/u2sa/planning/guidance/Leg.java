package org.u2sa.planning.guidance;

/**
 * A straight leg on a horizontal plane: north and east [m], relative to any origin. Immutable.
 *
 * <p>Along-track is measured from the start toward the end; cross-track is positive to the right of
 * the direction of travel.
 */
public record Leg(double startNorthM, double startEastM, double endNorthM, double endEastM) {
  /** Shorter legs have no defined direction [m]. */
  static final double SHORTEST_M = 1.0e-3;

  /** Length of the leg [m]. */
  public double lengthM() {
    return Math.hypot(endNorthM - startNorthM, endEastM - startEastM);
  }

  /** Whether start and end are too close to define a direction. */
  public boolean isPoint() {
    return lengthM() < SHORTEST_M;
  }

  /** Direction of travel [rad, clockwise from north, -π…π]; 0 if the leg {@link #isPoint}. */
  public double bearingRad() {
    return isPoint() ? 0.0 : Math.atan2(endEastM - startEastM, endNorthM - startNorthM);
  }

  /** Along-track distance of a point [m]; negative before the start. */
  public double alongM(double northM, double eastM) {
    double bearing = bearingRad();
    return (northM - startNorthM) * Math.cos(bearing) + (eastM - startEastM) * Math.sin(bearing);
  }

  /** Cross-track distance of a point to the right of the leg [m]; negative to the left. */
  public double acrossM(double northM, double eastM) {
    double bearing = bearingRad();
    return (eastM - startEastM) * Math.cos(bearing) - (northM - startNorthM) * Math.sin(bearing);
  }

  /** Remaining along-track distance of a point [m]; negative past the finish line. */
  public double remainingM(double northM, double eastM) {
    return lengthM() - alongM(northM, eastM);
  }

  /** North coordinate of the leg's line at an along-track distance [m]. */
  public double northAtM(double alongM) {
    return startNorthM + alongM * Math.cos(bearingRad());
  }

  /** East coordinate of the leg's line at an along-track distance [m]. */
  public double eastAtM(double alongM) {
    return startEastM + alongM * Math.sin(bearingRad());
  }

  /** Change of direction from this leg to the next [rad, -π…π], positive to the right. */
  public double turnToRad(Leg next) {
    return wrapped(next.bearingRad() - bearingRad());
  }

  /** Shortest distance from a point to the leg, between its ends [m]. */
  public double distanceM(double northM, double eastM) {
    double along = Math.max(0.0, Math.min(lengthM(), alongM(northM, eastM)));
    return Math.hypot(northM - northAtM(along), eastM - eastAtM(along));
  }

  /** Wraps an angle to -π…π [rad]. */
  public static double wrapped(double angleRad) {
    return Math.IEEEremainder(angleRad, 2.0 * Math.PI);
  }
}
