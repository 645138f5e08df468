package org.u2sa.device.port;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A controller of two motors with encoders. Both motors are off until commanded, and after the
 * controller's command time-out.
 */
public interface MotorController extends Device<MotorController.Counts> {
  /**
   * Encoder counts.
   *
   * @param measuredAtMicros time of the request
   * @param first counts of the first motor's encoder, wrapping at 32 bits
   * @param second counts of the second motor's encoder, wrapping at 32 bits
   * @param batteryV voltage of the motors' battery [V]; empty while unknown
   */
  record Counts(long measuredAtMicros, int first, int second, OptionalDouble batteryV)
      implements Reading {}

  /**
   * {@inheritDoc} Unlike other ports, also empty after a loss until the controller answers and is
   * set up again, before which it does not drive.
   */
  @Override
  Optional<Counts> read(long nowMicros);

  /**
   * Sets the power of both motors.
   *
   * @param first power [%], −100…100
   * @param second power [%], −100…100
   */
  void drive(double first, double second);

  /**
   * Sets the speeds that the controller's own loops hold until {@link #drive}.
   *
   * @param first counts of its encoder per second
   * @param second counts of its encoder per second
   * @return false, without effect, if the controller has no such loops
   */
  default boolean turn(double first, double second) {
    return false;
  }

  /** Switches both motors off immediately, with priority over pending commands. */
  void stop(long nowMicros);

  /** Releases the controller without changing the motors, for a successor. */
  void leave();

  /** Switches both motors off and releases the controller. */
  @Override
  void close();
}
