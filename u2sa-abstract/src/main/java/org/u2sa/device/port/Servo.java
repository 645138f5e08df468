package org.u2sa.device.port;

import java.util.OptionalDouble;

/** A servo, which turns a control surface, a rudder or a camera to an angle and holds it. */
public interface Servo extends Device<Servo.Position> {
  /**
   * Status reported by the servo.
   *
   * @param angleRad its angle, positive as commanded [rad]; empty if it does not measure it
   */
  record Position(long measuredAtMicros, OptionalDouble angleRad) implements Reading {}

  /**
   * Sets the angle, which the servo holds until the next call.
   *
   * @param angleRad from the centre of the travel [rad]
   */
  void turn(double angleRad);

  /** Releases the servo without moving it, for a hot swap. */
  void leave();
}
