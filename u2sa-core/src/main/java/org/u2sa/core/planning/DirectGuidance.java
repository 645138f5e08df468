package org.u2sa.core.planning;

import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * The thesis's own guidance (4.5.2.4), kept for teaching: always straight towards the waypoint.
 *
 * <p>The point is a unit vector in the vehicle's level plane; its z is the climb wanted, −1 (down,
 * full climb) … 1 (full descent), 0 to hold altitude. It follows no line and knows no finish line:
 * a vehicle that misses circles until it hits.
 */
final class DirectGuidance implements WaypointGuidance {
  /** Differences of altitude up to this hold altitude: 10 ft [m]. */
  static final double HOLD_M = 10.0 * 0.3048;

  /** Differences of altitude from this on are full climb or descent: 1000 ft [m]. */
  static final double FULL_M = 1000.0 * 0.3048;

  @Override
  public void begin(Optional<Place> start) {
    // Neither where the vehicle comes from nor where it was matters.
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

  /** The share of full descent for a difference of height [m, down positive]. */
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
    return true; // thesis 3.2.3.4: complete as soon as the vehicle is within the threshold
  }

  @Override
  public boolean isApproaching() {
    return true;
  }
}
