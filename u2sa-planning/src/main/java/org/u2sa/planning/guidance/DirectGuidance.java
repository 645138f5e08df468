package org.u2sa.planning.guidance;

import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * Guidance of the thesis (4.5.2.4), kept for teaching: always straight toward the waypoint.
 *
 * <p>The point is a unit vector in the vehicle's horizontal plane; its z is the demanded climb, −1
 * (down, full climb) … 1 (full descent), 0 to hold altitude. It follows no line and has no finish
 * line: a vehicle that misses the waypoint circles until it hits it.
 */
final class DirectGuidance implements WaypointGuidance {
  /** Altitude is held within this difference: 10 ft [m]. */
  static final double HOLD_M = 10.0 * 0.3048;

  /** Altitude difference from which on climb or descent is full: 1000 ft [m]. */
  static final double FULL_M = 1000.0 * 0.3048;

  @Override
  public void begin(Optional<Place> start) {
    // Neither the start of the leg nor past positions matter.
  }

  @Override
  public Point towards(Vehicle vehicle, Place target, double threshold, Optional<Place> after) {
    return bodyPoint(vehicle, vehicle.nedOf(target));
  }

  @Override
  public Point bodyPoint(Vehicle vehicle, Point ned) {
    double distance = Math.hypot(ned.x(), ned.y());
    double scale = distance > 0.0 ? 1.0 / distance : 0.0;
    return vehicle.levelBody(Point.of(scale * ned.x(), scale * ned.y(), scaled(ned.z())));
  }

  /** Share of full descent for a height difference [m, down positive]. */
  static double scaled(double downM) {
    double share = (Math.abs(downM) - HOLD_M) / (FULL_M - HOLD_M);
    return Math.copySign(Math.max(0.0, Math.min(1.0, share)), downM);
  }

  @Override
  public boolean hasPassed() {
    return false;
  }

  @Override
  public boolean isNearest() {
    return true; // thesis 3.2.3.4: complete once the vehicle is within the threshold
  }

  @Override
  public boolean isApproaching() {
    return true;
  }
}
