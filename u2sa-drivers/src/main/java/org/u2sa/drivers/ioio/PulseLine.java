package org.u2sa.drivers.ioio;

import ioio.lib.api.PulseInput;
import ioio.lib.api.exception.ConnectionLostException;
import java.util.OptionalDouble;

/**
 * A pulse input of the board, read without blocking.
 *
 * <p>The library can only wait for a pulse. When interrupted, it still returns an available pulse,
 * and otherwise immediately throws an exception, which is slow. In lockstep, where the board's
 * bytes are visible before the library receives them, the library is queried only when those bytes
 * may contain a pulse. Confined to the service's thread.
 */
final class PulseLine {
  // INCAP_REPORT: a pulse, followed by input number, 0 to 8, and length
  // (docs/drivers/ioio-protocol.md)
  private static final byte REPORT = 0x1C;
  private static final int INPUT = 0x0F;
  private static final int LAST_INPUT = 8;
  private static final int UNUSED = 0x30;

  private final PulseInput input;
  private boolean seesBytes;
  private int told; // upper bound of unread pulses: other bytes may look like a report

  PulseLine(PulseInput input) {
    this.input = input;
  }

  /** Inspects bytes before the library receives them. */
  void comes(byte[] bytes) {
    seesBytes = true;
    for (int i = 0; i < bytes.length; i++) {
      told += bytes[i] == REPORT && (i + 1 == bytes.length || isInput(bytes[i + 1])) ? 1 : 0;
    }
  }

  private static boolean isInput(byte octet) {
    return (octet & UNUSED) == 0 && (octet & INPUT) <= LAST_INPUT;
  }

  /** Width [s] of the oldest unread pulse; empty if none. */
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
