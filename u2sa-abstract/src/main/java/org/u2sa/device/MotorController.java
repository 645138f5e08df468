package org.u2sa.device;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A controller of two motors with encoders. Both motors are off until it is told to drive, and when
 * it has not been told anything for its own time-out.
 */
public interface MotorController extends Device<MotorController.Counts> {
  /**
   * What it counted.
   *
   * @param measuredAtMicros time at which the counts were asked for
   * @param first counts of the first motor's encoder, 32 bits that wrap
   * @param second counts of the second motor's encoder, 32 bits that wrap
   * @param batteryV voltage of the motors' battery [V]; empty while unknown
   */
  record Counts(long measuredAtMicros, int first, int second, OptionalDouble batteryV)
      implements Reading {}

  /**
   * {@inheritDoc} Unlike other ports: empty also after a loss, until the controller answers and is
   * set up again. It drives only then.
   */
  @Override
  Optional<Counts> read(long nowMicros);

  /**
   * Sets what the motors do from now on.
   *
   * @param first share of full power [%], −100…100
   * @param second share of full power [%], −100…100
   */
  void drive(double first, double second);

  /**
   * Sets the speeds that the controller holds by its own loops from now on, until {@link #drive}.
   *
   * @param first counts of its encoder per second
   * @param second counts of its encoder per second
   * @return false if the controller has no such loops: then nothing changes
   */
  default boolean turn(double first, double second) {
    return false;
  }

  /** Switches both motors off at once, whatever else is under way. */
  void stop(long nowMicros);

  /** Lets go of the controller and leaves the motors as they are, for a successor. */
  void leave();

  /** Switches both motors off and lets go of the controller. */
  @Override
  void close();
}
