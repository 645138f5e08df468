package org.u2sa.device;

/** Encoders at a left and a right wheel, apart from what drives them. */
public interface WheelEncoder extends Device<WheelEncoder.Ticks> {
  /**
   * What they counted.
   *
   * @param measuredAtMicros time at which they were read
   * @param left counts of the left wheel's encoder, forward positive, 32 bits that wrap
   * @param right counts of the right wheel's encoder, forward positive, 32 bits that wrap
   */
  record Ticks(long measuredAtMicros, int left, int right) implements Reading {}
}
