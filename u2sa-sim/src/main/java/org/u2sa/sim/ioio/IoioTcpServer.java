package org.u2sa.sim.ioio;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import org.u2sa.interfaces.time.Clock;

/**
 * Serves a simulated board over TCP in real time, to one host at a time because the board has one
 * channel. Three daemon threads: acceptor/reader, clock and sender.
 *
 * <p>A host is read at up to 2 MB/s, so that a flood leaves time for the vehicle. While the process
 * is suspended or the machine sleeps, the board's clock stands still.
 */
public final class IoioTcpServer implements AutoCloseable {
  private static final long PAUSE_MS = 2;
  private static final int BUFFER = 4096;
  private static final long PAUSE_MICROS = 1_000 * PAUSE_MS;
  private static final long RETRY_MS = 100;
  private static final long LONGEST_GAP_MICROS = 1_000_000;

  private final Object lock = new Object(); // guards the firmware and the fields after the threads
  private final IoioFirmware firmware;
  private final Clock clock;
  private final Hosts source;
  private final Thread hosts = new Thread(this::awaitHosts, "u2sa-ioio-server");
  private final Thread time = new Thread(this::passTime, "u2sa-ioio-server-time");
  private final Thread sender = new Thread(this::send, "u2sa-ioio-server-sender");
  private Hosts.Host host; // null if none is connected
  private int credit; // bytes that may be read until the credit is renewed
  private long creditMicros; // time of the next renewal
  private long lastMicros; // clock time of the last advance
  private long skippedMicros; // time not counted by the board
  private boolean powered = true;
  private boolean held;
  private boolean closed;

  /**
   * Serves on the loopback interface.
   *
   * @param port 0 for an ephemeral port
   * @throws UncheckedIOException if the port is taken
   */
  public IoioTcpServer(IoioFirmware firmware, Clock clock, int port) {
    this(firmware, clock, new Loopback(port));
  }

  /** Serves the hosts of a source, which is closed with the server. */
  public IoioTcpServer(IoioFirmware firmware, Clock clock, Hosts source) {
    this.firmware = firmware;
    this.clock = clock;
    this.source = source;
    lastMicros = clock.micros();
    firmware.advance(lastMicros); // start the firmware clock before accepting hosts
    for (Thread thread : new Thread[] {hosts, time, sender}) {
      thread.setDaemon(true);
      thread.start();
    }
  }

  /** The listening port on the loopback interface; −1 with a source of hosts. */
  public int port() {
    return source instanceof Loopback own ? own.server.getLocalPort() : -1;
  }

  /** Whether a host is connected. */
  public boolean isConnected() {
    synchronized (lock) {
      return host != null;
    }
  }

  /** Switches the board on or off; when off, connections drop and all pins float. */
  public void power(boolean on) {
    synchronized (lock) {
      powered = on;
      if (!on) {
        hangUp(host);
      }
    }
  }

  /**
   * Freezes or resumes the board. While frozen it neither reads nor sends, and its pins keep their
   * state.
   */
  public void hold(boolean on) {
    synchronized (lock) {
      held = on;
      lock.notifyAll();
    }
  }

  private void awaitHosts() {
    try {
      while (!isClosed()) {
        try {
          serve(source.next());
        } catch (IOException e) {
          pause(); // no host connected
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void pause() throws InterruptedException {
    synchronized (lock) {
      if (!closed) {
        lock.wait(RETRY_MS);
      }
    }
  }

  private void serve(Hosts.Host next) {
    String why = "the board is off";
    try {
      if (begin(next)) {
        listen(next.input());
        why = "it closed the connection";
      }
    } catch (SocketTimeoutException e) {
      why = "it was silent for too long";
    } catch (IOException e) {
      why = isHost(next) ? "the connection broke: " + e.getMessage() : "it closed the connection";
    } catch (RuntimeException e) {
      why = "the board failed at its message: " + e;
    }
    synchronized (lock) {
      why = firmware.trouble().isEmpty() ? why : "the board rejected " + firmware.trouble();
      hangUp(next);
    }
    source.ended(next, why);
  }

  private boolean isHost(Hosts.Host which) {
    synchronized (lock) {
      return host == which;
    }
  }

  private boolean begin(Hosts.Host next) {
    synchronized (lock) {
      if (powered && !closed) {
        host = next;
        firmware.open();
        lock.notifyAll();
      }
      return host == next;
    }
  }

  private void listen(InputStream in) throws IOException {
    byte[] buffer = new byte[BUFFER];
    for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
      synchronized (lock) {
        awaitRelease();
        credit -= count;
        firmware.accept(buffer, 0, count);
        hangUpIfRefused();
        lock.notifyAll();
      }
    }
  }

  private void awaitRelease() throws IOException {
    try {
      while ((held || credit <= 0) && host != null) {
        lock.wait();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }

  private void passTime() {
    synchronized (lock) {
      try {
        while (!closed) {
          long now = clock.micros();
          if (Math.abs(now - lastMicros) > LONGEST_GAP_MICROS) {
            skippedMicros += now - lastMicros;
            creditMicros = now;
          }
          lastMicros = now;
          if (now >= creditMicros) {
            credit = BUFFER;
            creditMicros = now + PAUSE_MICROS;
          }
          firmware.advance(now - skippedMicros);
          lock.notifyAll();
          lock.wait(PAUSE_MS);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // interrupted only to shut down
      } catch (RuntimeException e) {
        closed = true;
        hangUp(host);
        source.failed(e);
      }
    }
  }

  private void send() {
    byte[] buffer = new byte[BUFFER];
    try {
      while (!isClosed()) {
        Hosts.Host receiver;
        int count;
        synchronized (lock) {
          count = host == null || held ? 0 : firmware.output(buffer);
          receiver = host;
          if (count == 0) {
            hangUpIfRefused();
            lock.wait();
            continue;
          }
        }
        sendTo(receiver, buffer, count);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Blocks on a slow host; the board's queue may overflow during that time. */
  private void sendTo(Hosts.Host receiver, byte[] buffer, int count) {
    try {
      receiver.output().write(buffer, 0, count);
      receiver.output().flush();
    } catch (IOException e) {
      synchronized (lock) {
        if (host == receiver) {
          hangUp(receiver);
        }
      }
    }
  }

  private void hangUpIfRefused() {
    if (host != null && !firmware.isOpen()) {
      hangUp(host);
    }
  }

  /**
   * Call with the lock held.
   *
   * @param leaving may be null
   */
  private void hangUp(Hosts.Host leaving) {
    if (host != null) {
      host = null;
      firmware.lost();
    }
    lock.notifyAll();
    if (leaving != null) {
      close(leaving.end());
    }
  }

  private static void close(AutoCloseable socket) {
    try {
      socket.close();
    } catch (Exception e) {
      throw new IllegalStateException("cannot close a socket", e);
    }
  }

  private boolean isClosed() {
    synchronized (lock) {
      return closed;
    }
  }

  /** Closes all connections and stops all threads. */
  @Override
  public void close() {
    synchronized (lock) {
      closed = true;
      hangUp(host);
    }
    close(source);
    try {
      for (Thread thread : new Thread[] {hosts, time, sender}) {
        thread.join();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Hosts on this machine, without a log. */
  private static final class Loopback implements Hosts {
    private final ServerSocket server;

    Loopback(int port) {
      try {
        server = new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
      } catch (IOException e) {
        throw new UncheckedIOException("simulated IOIO: port " + port + ": " + e.getMessage(), e);
      }
    }

    @Override
    public Host next() throws IOException {
      Socket socket = server.accept();
      socket.setTcpNoDelay(true);
      return new Host(
          socket.getRemoteSocketAddress().toString(),
          socket.getInputStream(),
          socket.getOutputStream(),
          socket);
    }

    @Override
    public void close() throws IOException {
      server.close();
    }
  }
}
