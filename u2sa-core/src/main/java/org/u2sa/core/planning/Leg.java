package org.u2sa.core.planning;

/**
 * A straight leg on a horizontal plane: north and east [m], about any origin. Immutable.
 *
 * <p>Along is counted from the start towards the end, across is positive to the right of the
 * direction of travel.
 */
public record Leg(double startNorthM, double startEastM, double endNorthM, double endEastM) {
  /** Shorter legs have no direction to speak of [m]. */
  static final double SHORTEST_M = 1.0e-3;

  /** Length of the leg [m]. */
  public double lengthM() {
    return Math.hypot(endNorthM - startNorthM, endEastM - startEastM);
  }

  /** Whether start and end are too near to each other for a direction. */
  public boolean isPoint() {
    return lengthM() < SHORTEST_M;
  }

  /** Direction of travel [rad, clockwise from north, -π…π]; 0 if the leg {@link #isPoint}. */
  public double bearingRad() {
    return isPoint() ? 0.0 : Math.atan2(endEastM - startEastM, endNorthM - startNorthM);
  }

  /**
   * How far along the leg the point's foot lies [m]; negative before the start, more than the
   * length past the end.
   */
  public double alongM(double northM, double eastM) {
    double bearing = bearingRad();
    return (northM - startNorthM) * Math.cos(bearing) + (eastM - startEastM) * Math.sin(bearing);
  }

  /** How far to the right of the leg the point lies [m]; negative to the left. */
  public double acrossM(double northM, double eastM) {
    double bearing = bearingRad();
    return (eastM - startEastM) * Math.cos(bearing) - (northM - startNorthM) * Math.sin(bearing);
  }

  /**
   * How far the point still has to go along the leg [m]; negative when it is past the finish line.
   */
  public double remainingM(double northM, double eastM) {
    return lengthM() - alongM(northM, eastM);
  }

  /** North of the point of the leg's line that lies so far along [m]. */
  public double northAtM(double alongM) {
    return startNorthM + alongM * Math.cos(bearingRad());
  }

  /** East of the point of the leg's line that lies so far along [m]. */
  public double eastAtM(double alongM) {
    return startEastM + alongM * Math.sin(bearingRad());
  }

  /** Change of direction from this leg to the next [rad, -π…π], positive to the right. */
  public double turnToRad(Leg next) {
    return wrapped(next.bearingRad() - bearingRad());
  }

  /** The shortest distance from a point to the leg between its ends [m]. */
  public double distanceM(double northM, double eastM) {
    double along = Math.max(0.0, Math.min(lengthM(), alongM(northM, eastM)));
    return Math.hypot(northM - northAtM(along), eastM - eastAtM(along));
  }

  /** The same direction in -π…π [rad]. */
  static double wrapped(double angleRad) {
    return Math.IEEEremainder(angleRad, 2.0 * Math.PI);
  }
}
