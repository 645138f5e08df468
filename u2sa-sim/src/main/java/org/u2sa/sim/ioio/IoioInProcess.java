package org.u2sa.sim.ioio;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.function.Consumer;

/**
 * A simulated board on a cable within the process, in lockstep: its time moves in {@link #exchange}
 * only, which returns when the host has taken every byte. So the host knows the same at the same
 * time in every run.
 *
 * <p>The host reads on a thread of its own until its first wait in an exchange. To wake that thread
 * each time would take longer than what it reads; so from then on each exchange hands over the
 * bytes itself, and the thread waits for the end of the connection.
 *
 * <p>The host opens a connection by {@link #connect}, then gets the streams of that one; they end
 * when the board or the host ends it, and the reader then closes its stream. For any thread; one
 * thread reads.
 */
public final class IoioInProcess {
  private static final int CABLE = 1 << 16;
  private static final long SLICE_MICROS = 20_000; // the board's own queue holds more than this

  private final Object lock = new Object(); // guards everything below
  private final IoioFirmware firmware;
  private final ByteQueue cable = new ByteQueue(CABLE); // to the host
  private final byte[] scratch = new byte[1024];
  private boolean powered = true;
  private int session; // 0 before the first
  private boolean connected;
  private boolean readerWaits;
  private boolean readerGone;
  private boolean isReading; // from the first byte asked for until it closes its end
  private boolean handsOver; // what comes, in exchanges; the reader waits for the end
  private boolean hasBegun;
  private long atMicros;

  /** A cable to this board, which nothing else touches from now on. */
  public IoioInProcess(IoioFirmware firmware) {
    this.firmware = firmware;
  }

  /** Opens a connection; one that is open ends. Returns false if the board has no power. */
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

  /** Ends the connection, as a cable that is pulled. */
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

  /** Moves what the board has for the host onto the cable, and wakes the reader if it matters. */
  private void pass() {
    for (int count = firmware.output(scratch); count > 0; count = firmware.output(scratch)) {
      cable.push(scratch, 0, count);
    }
    if (cable.size() > 0 && !handsOver || hasEnded()) {
      lock.notifyAll();
    }
  }

  /**
   * Lets the board's time pass to a time of the run [µs], and returns when the host has taken what
   * came of it. Ends early, with the thread's flag set again, if the thread is interrupted.
   *
   * @param host takes bytes on the calling thread, unless the host's reader did
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
      host.accept(handedOver); // not under the lock: it may write, or end the connection
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
      while (connected ? !isTaken() : isReading) { // a reader whose connection ended closes soon
        lock.wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Whether the host has taken all and asks for more, or has closed its end. */
  private boolean isTaken() {
    boolean isNothingLeft = handsOver || cable.size() == 0;
    return readerGone || isNothingLeft && readerWaits && !hasEnded();
  }

  /** Whether the board has ended the connection, and the host has taken all that came before. */
  private boolean hasEnded() {
    return cable.size() == 0 && !firmware.isOpen();
  }

  /** The bytes from the board, of the connection opened last. */
  public InputStream input() {
    synchronized (lock) {
      return new FromBoard(session);
    }
  }

  /** The bytes to the board, of the connection opened last. */
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
