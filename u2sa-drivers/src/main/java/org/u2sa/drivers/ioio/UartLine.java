package org.u2sa.drivers.ioio;

import ioio.lib.api.Uart;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * A UART of the board, read and written without waiting. Bytes to the device leave somewhat slower
 * than the line could take them, so that they never fill the 256 bytes that the board holds.
 * Belongs to the service's thread.
 */
final class UartLine {
  private static final double BITS_PER_BYTE = 10.0;
  private static final double SHARE = 0.8; // of the line's rate
  private static final int PACKET = 64; // what the board takes in one message

  private final InputStream in;
  private final OutputStream out;
  private final double bytesPerS;
  private final SendingLoop loop = new SendingLoop();
  private byte[] waiting = new byte[0];
  private double credit;
  private long atMicros = Long.MIN_VALUE;

  UartLine(Uart uart, int baud) {
    in = uart.getInputStream();
    out = uart.getOutputStream();
    bytesPerS = baud / BITS_PER_BYTE * SHARE;
  }

  /** Takes what has come; returns how many bytes. */
  int read(byte[] buffer) throws IOException {
    int available = in.available();
    return available == 0 ? 0 : in.read(buffer, 0, Math.min(available, buffer.length));
  }

  /** How many bytes for the device wait. */
  int waiting() {
    return waiting.length;
  }

  /** Bytes for the device; they leave in {@link #send}. */
  void write(byte[] bytes) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.write(waiting, 0, waiting.length);
    all.write(bytes, 0, bytes.length);
    waiting = all.toByteArray();
  }

  /**
   * Sends as much of it as the line takes by now.
   *
   * @param lockstep counts what the library sends, and all is sent on return; empty in real time
   */
  void send(long nowMicros, Optional<FlushCounter> lockstep) throws IOException {
    double elapsedS = atMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(nowMicros - atMicros);
    atMicros = nowMicros;
    credit = Math.min(PACKET, credit + Math.max(0.0, elapsedS) * bytesPerS);
    int count = Math.min((int) credit, waiting.length);
    if (count == 0) {
      return;
    }
    credit -= count;
    if (lockstep.isPresent()) {
      loop.send(out, waiting, count, lockstep.get());
    } else {
      out.write(waiting, 0, count);
    }
    waiting = Arrays.copyOfRange(waiting, count, waiting.length);
  }
}
