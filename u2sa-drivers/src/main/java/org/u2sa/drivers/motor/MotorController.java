package org.u2sa.drivers.motor;

import java.util.OptionalDouble;

/**
 * All that {@link WheelMotors} knows of a controller of two motors with encoders. Belongs to one
 * thread; no call waits for the device.
 */
public interface MotorController extends AutoCloseable {
  /**
   * What the controller said last.
   *
   * @param connected whether it is there, answers, and was set up: only then it drives
   * @param measuredAtMicros when the counts were asked for, time of the run's clock [µs]
   * @param firstCounts of the first motor's encoder, of 32 bits that wrap
   * @param secondCounts of the second motor's encoder, likewise
   * @param batteryV voltage of the motors' battery [V]; empty if not known yet
   */
  record Reading(
      boolean connected,
      long measuredAtMicros,
      int firstCounts,
      int secondCounts,
      OptionalDouble batteryV) {}

  /** Hears and asks the controller, and returns what it said last. */
  Reading read(long nowMicros);

  /**
   * What the motors are to do from now on.
   *
   * @param first share of full power [%], −100…100
   * @param second likewise
   */
  void drive(double first, double second);

  /** Both motors off, sent at once, whatever else is under way. */
  void stop(long nowMicros);

  /** How often it said what cannot be read, or nothing where an answer was due. */
  long malformed();

  /** Closes the link and leaves the motors as they are, for who drives them on over a new one. */
  void leave();

  /** Both motors off, and the link closed. */
  @Override
  void close();
}
