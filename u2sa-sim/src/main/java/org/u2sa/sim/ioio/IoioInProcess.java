package org.u2sa.sim.ioio;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.function.Consumer;

/**
 * A simulated board connected in-process, in lockstep: time advances only in {@link #exchange},
 * which returns once the host has consumed every byte, so runs are deterministic.
 *
 * <p>The host's own thread reads until its first wait in an exchange. Waking it each time costs
 * more than reading, so from then on each exchange delivers the bytes itself, and the thread only
 * waits for the end of the connection.
 *
 * <p>The host calls {@link #connect} and then obtains the connection's streams, which end when
 * either side closes; the reader then closes its stream. Thread-safe, with a single reader.
 */
public final class IoioInProcess {
  private static final int CABLE = 1 << 16;
  private static final long SLICE_MICROS =
      20_000; // less than the capacity of the board's own queue

  private final Object lock = new Object(); // guards everything below
  private final IoioFirmware firmware;
  private final ByteQueue cable = new ByteQueue(CABLE); // bytes to the host
  private final byte[] scratch = new byte[1024];
  private boolean powered = true;
  private int session; // 0 before the first
  private boolean connected;
  private boolean readerWaits;
  private boolean readerGone;
  private boolean isReading; // from the first read until the reader closes its stream
  private boolean handsOver; // exchanges deliver the bytes; the reader waits for the end
  private boolean hasBegun;
  private long atMicros;

  /** Takes ownership of a board. */
  public IoioInProcess(IoioFirmware firmware) {
    this.firmware = firmware;
  }

  /** Opens a connection, ending an open one. Returns false if the board is off. */
  public boolean connect() {
    synchronized (lock) {
      end();
      if (!powered) {
        return false;
      }
      session++;
      connected = true;
      readerWaits = false;
      readerGone = false;
      isReading = false;
      handsOver = false;
      firmware.open();
      pass();
      return true;
    }
  }

  /** Ends the connection, like unplugging the cable. */
  public void disconnect() {
    synchronized (lock) {
      end();
    }
  }

  /** Switches the board on or off. */
  public void power(boolean on) {
    synchronized (lock) {
      powered = on;
      if (!on) {
        end();
      }
    }
  }

  private void end() {
    if (connected) {
      connected = false;
      firmware.lost();
      cable.clear();
    }
    lock.notifyAll();
  }

  /** Moves pending board bytes to the connection and wakes the reader if needed. */
  private void pass() {
    for (int count = firmware.output(scratch); count > 0; count = firmware.output(scratch)) {
      cable.push(scratch, 0, count);
    }
    if (cable.size() > 0 && !handsOver || hasEnded()) {
      lock.notifyAll();
    }
  }

  /**
   * Advances the board to a time of the run [µs] and returns once the host has consumed the
   * resulting bytes. Returns early, with the interrupt flag set, if interrupted.
   *
   * @param host consumes bytes on the calling thread if the host's reader does not
   */
  public void exchange(long nowMicros, Consumer<byte[]> host) {
    while (hasBegun && nowMicros - atMicros > SLICE_MICROS) {
      advance(atMicros + SLICE_MICROS, host);
    }
    hasBegun = true;
    advance(nowMicros, host);
  }

  private void advance(long micros, Consumer<byte[]> host) {
    atMicros = micros;
    byte[] handedOver;
    synchronized (lock) {
      firmware.advance(micros);
      if (connected) {
        pass();
      }
      handedOver = new byte[handsOver ? cable.size() : 0];
      cable.pull(handedOver, handedOver.length);
    }
    if (handedOver.length > 0) {
      host.accept(handedOver); // outside the lock: it may write or end the connection
    }
    synchronized (lock) {
      awaitReader();
      handsOver = connected && readerWaits;
    }
  }

  private void awaitReader() {
    try {
      if (hasEnded()) {
        lock.notifyAll();
      }
      while (connected ? !isTaken() : isReading) { // a reader whose connection ended closes shortly
        lock.wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether the host has consumed everything and is reading again, or has closed. */
  private boolean isTaken() {
    boolean isNothingLeft = handsOver || cable.size() == 0;
    return readerGone || isNothingLeft && readerWaits && !hasEnded();
  }

  /** Whether the board ended the connection and the host has consumed all earlier bytes. */
  private boolean hasEnded() {
    return cable.size() == 0 && !firmware.isOpen();
  }

  /** Bytes from the board on the latest connection. */
  public InputStream input() {
    synchronized (lock) {
      return new FromBoard(session);
    }
  }

  /** Bytes to the board on the latest connection. */
  public OutputStream output() {
    synchronized (lock) {
      return new ToBoard(session);
    }
  }

  private final class FromBoard extends InputStream {
    private final int number;

    FromBoard(int number) {
      this.number = number;
    }

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] target, int offset, int length) throws IOException {
      if (length == 0) {
        return 0;
      }
      synchronized (lock) {
        isReading |= session == number;
        try {
          while (isCurrent() && (handsOver || cable.size() == 0) && !hasEnded()) {
            readerWaits = true;
            lock.notifyAll();
            lock.wait();
          }
        } catch (InterruptedException e) {
          Thread.currentThread().interrupt();
          throw new IOException("interrupted while waiting for the board", e);
        }
        if (!isCurrent() || cable.size() == 0) {
          return -1;
        }
        readerWaits = false;
        int count = cable.pull(scratch, Math.min(length, scratch.length));
        System.arraycopy(scratch, 0, target, offset, count);
        return count;
      }
    }

    private boolean isCurrent() {
      return connected && session == number;
    }

    @Override
    public void close() {
      synchronized (lock) {
        if (session == number) {
          readerGone = true;
          isReading = false;
          end();
        }
      }
    }
  }

  private final class ToBoard extends OutputStream {
    private final int number;

    ToBoard(int number) {
      this.number = number;
    }

    @Override
    public void write(int octet) throws IOException {
      write(new byte[] {(byte) octet}, 0, 1);
    }

    @Override
    public void write(byte[] bytes, int offset, int length) throws IOException {
      synchronized (lock) {
        if (!connected || session != number) {
          throw new IOException("the board is not connected");
        }
        firmware.accept(bytes, offset, length);
        pass();
      }
    }
  }
}
