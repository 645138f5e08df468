package org.u2sa.core.control.cascade;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.HandOver;

/**
 * How the vehicle moves where no state says it. What the actuators do tells how it speeds up; what
 * it sees of the place to go to, which stands, corrects that: it comes nearer and sinks as fast as
 * the place comes nearer and rises, and turns as fast as the place wanders to the other side (a
 * complementary filter: Higgins, IEEE Transactions on Aerospace and Electronic Systems 11, 1975).
 * It counts as level, and motion across the line of sight as turning, from which it cannot be told.
 * Belongs to one thread.
 */
final class SeenMotion {
  private static final Attitude LEVEL = new Attitude(0.0, 0.0, 0.0);
  private static final double CORRECTION_S = 0.5;
  private static final double NEAR_M = 0.3; // nearer, a direction says nothing

  /** Faster than this, another place was seen, and nothing moved [m/s]. */
  private static final double JUMP_MPS = 20.0;

  private Point before = Point.ORIGIN;
  private Point velocity = Point.ORIGIN;
  private double turnRadPerS;

  /** Forgets what was seen. */
  void rest() {
    velocity = Point.ORIGIN;
    turnRadPerS = 0.0;
  }

  /**
   * The motion against the axes in which the vehicle lies now: heading 0, and level.
   *
   * @param place where to go: forward, right, down [m]
   * @param acceleration that the actuators have given since the call before, along the same axes
   *     [m/s²]
   * @param turnAcceleration the same, about the axis down [rad/s²]
   * @param stepS since the call before [s]; 0: unknown, and the motion counts as unchanged
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
      Point expected = velocity.plus(along(acceleration, stepS));
      velocity = expected.plus(along(seen.minus(expected), share));
      double expectedTurn = turnRadPerS + turnAcceleration * stepS;
      turnRadPerS = expectedTurn + share * (turn(place) / stepS - expectedTurn);
    }
    before = place;
    return new BodyMotion(LEVEL, velocity, Point.of(0.0, 0.0, turnRadPerS));
  }

  void handOver(HandOver state) {
    state.number("FORWARD", velocity.x()).number("RIGHT", velocity.y());
    state.number("DOWN", velocity.z()).number("TURN", turnRadPerS);
  }

  void takeOver(HandOver state) {
    velocity =
        Point.of(
            state.number("FORWARD").orElse(0.0),
            state.number("RIGHT").orElse(0.0),
            state.number("DOWN").orElse(0.0));
    turnRadPerS = state.number("TURN").orElse(0.0);
  }

  private static Point along(Point way, double times) {
    return Point.of(times * way.x(), times * way.y(), times * way.z());
  }

  /** Of the vehicle since the place was seen last, to the right positive [rad]. */
  private double turn(Point place) {
    boolean near =
        Math.min(Math.hypot(place.x(), place.y()), Math.hypot(before.x(), before.y())) < NEAR_M;
    double wandered = Math.atan2(place.y(), place.x()) - Math.atan2(before.y(), before.x());
    return near ? 0.0 : -Math.IEEEremainder(wandered, 2.0 * Math.PI);
  }
}
