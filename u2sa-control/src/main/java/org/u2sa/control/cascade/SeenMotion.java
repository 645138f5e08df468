package org.u2sa.control.cascade;

import org.u2sa.control.Transfer;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;

/**
 * Estimates the vehicle's motion without states. The actuators' effect predicts acceleration;
 * sightings of the stationary target correct it: approach speed, sink rate and turn rate follow
 * from how the target approaches, rises and moves to the other side (a complementary filter:
 * Higgins, IEEE Transactions on Aerospace and Electronic Systems 11, 1975). Assumes a level
 * vehicle, and treats motion across the line of sight as turning, because the two cannot be
 * distinguished. Not thread-safe.
 */
final class SeenMotion {
  private static final Attitude LEVEL = new Attitude(0.0, 0.0, 0.0);
  private static final double CORRECTION_S = 0.5;
  private static final double NEAR_M = 0.3; // nearer, the bearing is meaningless

  /** Apparent speed above which the target has changed rather than moved [m/s]. */
  private static final double JUMP_MPS = 20.0;

  private Point before = Point.ORIGIN;
  private Point velocity = Point.ORIGIN;
  private double turnRadPerS;

  /** Discards past sightings. */
  void rest() {
    velocity = Point.ORIGIN;
    turnRadPerS = 0.0;
  }

  /**
   * Computes the motion relative to the vehicle's current axes: heading 0, level.
   *
   * @param place target: forward, right, down [m]
   * @param acceleration acceleration by the actuators since the previous call, along the same axes
   *     [m/s²]
   * @param turnAcceleration angular acceleration about the down axis [rad/s²]
   * @param stepS time since the previous call [s]; 0 if unknown: the motion then counts as
   *     unchanged
   */
  BodyMotion step(Point place, Point acceleration, double turnAcceleration, double stepS) {
    if (stepS > 0.0 && place.minus(before).distance() > JUMP_MPS * stepS) {
      rest();
    } else if (stepS > 0.0) {
      double share = stepS / (CORRECTION_S + stepS);
      double away = Math.hypot(place.x(), place.y());
      double nearingMps = (Math.hypot(before.x(), before.y()) - away) / stepS;
      double ratio = away > 0.0 ? nearingMps / away : 0.0;
      Point seen = Point.of(ratio * place.x(), ratio * place.y(), (before.z() - place.z()) / stepS);
      Point expected = velocity.plus(acceleration.times(stepS));
      velocity = expected.plus(seen.minus(expected).times(share));
      double expectedTurn = turnRadPerS + turnAcceleration * stepS;
      turnRadPerS = expectedTurn + share * (turn(place) / stepS - expectedTurn);
    }
    before = place;
    return new BodyMotion(LEVEL, velocity, Point.of(0.0, 0.0, turnRadPerS));
  }

  void transfer(Transfer state) {
    velocity =
        Point.of(
            state.number("FORWARD", velocity.x()),
            state.number("RIGHT", velocity.y()),
            state.number("DOWN", velocity.z()));
    turnRadPerS = state.number("TURN", turnRadPerS);
  }

  /** Turn of the vehicle since the last sighting, right positive [rad]. */
  private double turn(Point place) {
    boolean near =
        Math.min(Math.hypot(place.x(), place.y()), Math.hypot(before.x(), before.y())) < NEAR_M;
    double wandered = Math.atan2(place.y(), place.x()) - Math.atan2(before.y(), before.x());
    return near ? 0.0 : -Math.IEEEremainder(wandered, 2.0 * Math.PI);
  }
}
