package org.u2sa.core.planning;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.HandOver;

/** How a vehicle is led to one waypoint after the other. */
interface WaypointGuidance {
  /**
   * Begins the way to a waypoint.
   *
   * @param start where the leg begins; empty: wherever the vehicle is
   */
  void begin(Optional<Place> start);

  /**
   * Where to go now, in BODY axes.
   *
   * @param threshold the waypoint's horizontal threshold [m]
   * @param after the waypoint after the target
   */
  Point towards(Vehicle vehicle, Place target, double threshold, Optional<Place> after);

  /**
   * Turns a vector given as north, east, down [m] into what this guidance hands to control, in BODY
   * axes.
   */
  Point bodyPoint(Vehicle vehicle, Point ned);

  /**
   * Whether the vehicle, at the last call of {@link #towards}, had gone past the target for good.
   */
  boolean hasPassed();

  /**
   * Whether a vehicle within the threshold gains nothing by going on towards the target: it will
   * come no nearer.
   */
  boolean isNearest();

  /**
   * Whether the vehicle is on its way to the target; false while it turns round, or flies away to
   * get room for the turn: how near it is then says nothing of the attempt.
   */
  boolean isApproaching();

  /** Writes down how the present leg stands, for a planner that takes over. */
  default void handOver(HandOver state) {}

  /** Resumes the leg of the previous planner; what it did not hand over starts fresh. */
  default void takeOver(HandOver state) {}
}
