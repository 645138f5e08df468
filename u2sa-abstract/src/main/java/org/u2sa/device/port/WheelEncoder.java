package org.u2sa.device.port;

/** Encoders of a left and a right wheel, separate from the motor controller. */
public interface WheelEncoder extends Device<WheelEncoder.Ticks> {
  /**
   * Encoder counts.
   *
   * @param measuredAtMicros time of reading
   * @param left counts of the left wheel's encoder, forward positive, wrapping at 32 bits
   * @param right counts of the right wheel's encoder, forward positive, wrapping at 32 bits
   */
  record Ticks(long measuredAtMicros, int left, int right) implements Reading {}
}
