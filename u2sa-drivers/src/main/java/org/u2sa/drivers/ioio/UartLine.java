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
 * A UART of the board, read and written without blocking. Output is paced slightly below the line
 * rate so that it never fills the board's 256-byte buffer. Confined to the service's thread.
 */
final class UartLine {
  private static final double BITS_PER_BYTE = 10.0;
  private static final double SHARE = 0.8; // fraction of the line rate
  private static final int PACKET = 64; // maximum payload of one board message

  private final InputStream in;
  private final OutputStream out;
  private final double bytesPerS;
  private Thread sender; // the library's ended thread, in lockstep; null before first use
  private byte[] waiting = new byte[0];
  private boolean isFull; // the library took less than it was given
  private double credit;
  private long atMicros = Long.MIN_VALUE;

  UartLine(Uart uart, int baud) {
    in = uart.getInputStream();
    out = uart.getOutputStream();
    bytesPerS = baud / BITS_PER_BYTE * SHARE;
  }

  /** Reads available bytes; returns their number. */
  int read(byte[] buffer) throws IOException {
    int available = in.available();
    return available == 0 ? 0 : in.read(buffer, 0, Math.min(available, buffer.length));
  }

  /** Number of bytes pending for the device. */
  int waiting() {
    return waiting.length;
  }

  /** Whether the board takes nothing, so that the library's queue is full. */
  boolean isFull() {
    return isFull;
  }

  /** Queues bytes for the device; {@link #send} sends them. */
  void write(byte[] bytes) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    all.write(waiting, 0, waiting.length);
    all.write(bytes, 0, bytes.length);
    waiting = all.toByteArray();
  }

  /**
   * Sends as many pending bytes as the line rate and, in real time, the library's queue permit.
   *
   * @param lockstep counter of the library's output; all is sent on return. Empty in real time
   */
  void send(long nowMicros, Optional<FlushCounter> lockstep) throws IOException {
    double elapsedS = atMicros == Long.MIN_VALUE ? 0.0 : Clock.seconds(nowMicros - atMicros);
    atMicros = nowMicros;
    credit = Math.min(PACKET, credit + Math.max(0.0, elapsedS) * bytesPerS);
    int count = Math.min((int) credit, waiting.length);
    if (count == 0) {
      return;
    }
    int sent = lockstep.isPresent() ? sendInLockstep(count, lockstep.get()) : offer(count);
    isFull = sent < count;
    credit -= sent;
    waiting = Arrays.copyOfRange(waiting, sent, waiting.length);
  }

  /**
   * Gives pending bytes to the library and returns how many it took. While its queue of 1024 bytes
   * is full, because the board gives no room, the library waits, but not on an interrupted thread.
   */
  private int offer(int count) throws IOException {
    boolean wasInterrupted = Thread.interrupted();
    Thread.currentThread().interrupt();
    int taken = 0;
    try {
      while (taken < count) {
        out.write(waiting[taken]);
        taken++;
      }
    } catch (IOException e) {
      if (Thread.currentThread().isInterrupted()) {
        throw e; // the line is closed: a wait would have cleared the flag
      }
    } finally {
      restore(wasInterrupted);
    }
    return taken;
  }

  private static void restore(boolean wasInterrupted) {
    Thread.interrupted();
    if (wasInterrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /**
   * In lockstep, lets the IOIO library send the data on this thread. The library uses one
   * asynchronous sender thread per UART, and waking and awaiting it costs far more than the
   * sending.
   *
   * <p>That thread sends once and is then ended by an interrupt. Afterwards this thread runs the
   * library's loop ({@code FlowControlledOutputStream.FlushThread.run}) and leaves it with an error
   * once everything is sent ({@link FlushCounter#run}). Its interrupt flag is set, so a wait for
   * the board returns immediately.
   *
   * @param sent counter of the library's output
   * @return {@code count}
   */
  private int sendInLockstep(int count, FlushCounter sent) throws IOException {
    sent.expect(count);
    out.write(waiting, 0, count);
    boolean wasInterrupted = Thread.interrupted();
    try {
      if (sender == null) {
        sender = end(sent.awaitSender());
      } else {
        Thread.currentThread().interrupt();
        sent.run(sender);
      }
      sent.requireAll();
    } catch (InterruptedException e) {
      wasInterrupted = true;
    } finally {
      restore(wasInterrupted);
    }
    return count;
  }

  private static Thread end(Thread library) throws InterruptedException {
    library.interrupt(); // the queue is empty and the loop is about to wait
    library.join();
    return library;
  }
}
