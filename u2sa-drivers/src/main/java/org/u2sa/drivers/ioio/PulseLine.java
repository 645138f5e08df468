package org.u2sa.drivers.ioio;

import ioio.lib.api.PulseInput;
import ioio.lib.api.exception.ConnectionLostException;
import java.util.OptionalDouble;

/**
 * A pulse input of the board, read without waiting.
 *
 * <p>The library can only wait for a pulse. An interrupted thread gets one that is there all the
 * same, and otherwise comes back at once, by an exception, which takes long. So where the board's
 * bytes are seen before the library gets them, as in lockstep, the library is asked only for pulses
 * that these bytes may have told of. Belongs to the service's thread.
 */
final class PulseLine {
  // INCAP_REPORT: a pulse; then which input, 0 to 8, and its length (docs/drivers/ioio-protocol.md)
  private static final byte REPORT = 0x1C;
  private static final int INPUT = 0x0F;
  private static final int LAST_INPUT = 8;
  private static final int UNUSED = 0x30;

  private final PulseInput input;
  private boolean seesBytes;
  private int told; // pulses not yet taken, at most: other bytes may look like a report

  PulseLine(PulseInput input) {
    this.input = input;
  }

  /** Takes note of bytes that the library is about to get. */
  void comes(byte[] bytes) {
    seesBytes = true;
    for (int i = 0; i < bytes.length; i++) {
      told += bytes[i] == REPORT && (i + 1 == bytes.length || isInput(bytes[i + 1])) ? 1 : 0;
    }
  }

  private static boolean isInput(byte octet) {
    return (octet & UNUSED) == 0 && (octet & INPUT) <= LAST_INPUT;
  }

  /** The width [s] of the oldest pulse not yet taken; empty if there is none. */
  OptionalDouble next() throws ConnectionLostException {
    if (seesBytes && told == 0) {
      return OptionalDouble.empty();
    }
    boolean wasInterrupted = Thread.interrupted();
    Thread.currentThread().interrupt();
    try {
      double widthS = input.getDurationBuffered();
      told = Math.max(0, told - 1);
      return OptionalDouble.of(widthS);
    } catch (InterruptedException e) {
      told = 0;
      return OptionalDouble.empty();
    } finally {
      if (!wasInterrupted) {
        Thread.interrupted();
      } else {
        Thread.currentThread().interrupt();
      }
    }
  }
}
