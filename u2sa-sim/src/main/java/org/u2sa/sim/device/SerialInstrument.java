package org.u2sa.sim.device;

import java.time.Instant;
import java.util.function.LongConsumer;
import org.u2sa.sim.sensor.UartTransmitter;
import org.u2sa.sim.sensor.UtcTime;

/**
 * The device side of a serial line. Times are since the start [µs], non-decreasing. Not
 * thread-safe.
 */
public final class SerialInstrument {
  /** The simulated receivers' date and time at the start. */
  static final UtcTime UTC = new UtcTime(Instant.parse("2026-06-01T12:00:00Z"));

  /** Receives bytes from the host at a baud rate. */
  @FunctionalInterface
  interface Input {
    void accept(long micros, int baud, byte[] bytes, int length);
  }

  private final LongConsumer clock;
  private final UartTransmitter line;
  private final Input input;

  SerialInstrument(LongConsumer clock, UartTransmitter line, Input input) {
    this.clock = clock;
    this.line = line;
    this.input = input;
  }

  /** Advances the device, and drops unread bytes that it sent before. */
  public void advance(long micros, long beforeMicros) {
    line.forget(beforeMicros);
    clock.accept(micros);
  }

  /** Current baud rate [bit/s]. */
  public int baud() {
    return line.baud();
  }

  /**
   * Reads the bytes that have arrived at the host.
   *
   * @param baud the host's baud rate; on a mismatch bytes are lost
   * @return number of bytes
   */
  public int take(long micros, int baud, byte[] buffer) {
    return line.take(micros, baud, buffer);
  }

  /**
   * Sends bytes to the device.
   *
   * @param baud the host's baud rate; on a mismatch with the device's, bytes are ignored
   */
  public void accept(long micros, int baud, byte[] bytes, int length) {
    input.accept(micros, baud, bytes, length);
  }
}
