package org.u2sa.planning.guidance;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.handover.HandOver;

/** Guides a vehicle from waypoint to waypoint. */
public interface WaypointGuidance {
  /**
   * Starts a leg to a waypoint.
   *
   * @param start start of the leg; empty for the vehicle's position
   */
  void begin(Optional<Place> start);

  /**
   * Target point in BODY axes.
   *
   * @param threshold the waypoint's horizontal threshold [m]
   * @param after the waypoint after the target
   */
  Point towards(Vehicle vehicle, Place target, double threshold, Optional<Place> after);

  /** Converts north, east, down [m] to the point passed to control, in BODY axes. */
  Point bodyPoint(Vehicle vehicle, Point ned);

  /** Whether the vehicle had definitely passed the target at the last call of {@link #towards}. */
  boolean hasPassed();

  /** Whether a vehicle within the threshold is at its closest point. */
  boolean isNearest();

  /**
   * Whether the vehicle approaches the target; false while it turns round or moves away to make
   * room for the turn; the distance then does not count for the attempt.
   */
  boolean isApproaching();

  /** Saves the state of the current leg for the planner that takes over. */
  default void handOver(HandOver state) {}

  /** Resumes the leg of the previous planner; missing values are reset. */
  default void takeOver(HandOver state) {}
}
