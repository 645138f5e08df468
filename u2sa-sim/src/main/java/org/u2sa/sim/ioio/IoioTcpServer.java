package org.u2sa.sim.ioio;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.u2sa.interfaces.time.Clock;

/**
 * Serves a simulated board over TCP in real time, to one host at a time because the board has one
 * channel. Three daemon threads: acceptor/reader, clock and sender.
 */
public final class IoioTcpServer implements AutoCloseable {
  private static final long PAUSE_MS = 2;
  private static final int BUFFER = 4096;

  private final Object lock = new Object(); // guards the firmware and the last four fields
  private final IoioFirmware firmware;
  private final Clock clock;
  private final ServerSocket server;
  private final Thread hosts = new Thread(this::awaitHosts, "u2sa-ioio-server");
  private final Thread time = new Thread(this::passTime, "u2sa-ioio-server-time");
  private final Thread sender = new Thread(this::send, "u2sa-ioio-server-sender");
  private Socket host; // null if none is connected
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
    this.firmware = firmware;
    this.clock = clock;
    try {
      server = new ServerSocket(port, 1, InetAddress.getLoopbackAddress());
    } catch (IOException e) {
      throw new UncheckedIOException("simulated IOIO: port " + port + ": " + e.getMessage(), e);
    }
    firmware.advance(clock.micros()); // start the firmware clock before accepting hosts
    for (Thread thread : new Thread[] {hosts, time, sender}) {
      thread.setDaemon(true);
      thread.start();
    }
  }

  /** The listening port. */
  public int port() {
    return server.getLocalPort();
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
        hangUp();
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
    while (!isClosed()) {
      try (Socket socket = server.accept()) {
        socket.setTcpNoDelay(true);
        if (begin(socket)) {
          listen(socket);
        }
      } catch (IOException e) {
        continue; // host disconnected; accept the next
      } finally {
        synchronized (lock) {
          hangUp();
        }
      }
    }
  }

  private boolean begin(Socket socket) {
    synchronized (lock) {
      if (powered) {
        host = socket;
        firmware.open();
        lock.notifyAll();
      }
      return powered;
    }
  }

  private void listen(Socket socket) throws IOException {
    InputStream in = socket.getInputStream();
    byte[] buffer = new byte[BUFFER];
    for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
      synchronized (lock) {
        awaitRelease();
        firmware.accept(buffer, 0, count);
        hangUpIfRefused();
        lock.notifyAll();
      }
    }
  }

  private void awaitRelease() throws IOException {
    try {
      while (held && host != null) {
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
          firmware.advance(clock.micros());
          lock.notifyAll();
          lock.wait(PAUSE_MS);
        }
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // interrupted only to shut down
      }
    }
  }

  private void send() {
    byte[] buffer = new byte[BUFFER];
    try {
      while (!isClosed()) {
        Socket receiver;
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

  /** Blocks on a slow host; the board's queue may overflow meanwhile. */
  private void sendTo(Socket receiver, byte[] buffer, int count) {
    try {
      OutputStream out = receiver.getOutputStream();
      out.write(buffer, 0, count);
      out.flush();
    } catch (IOException e) {
      synchronized (lock) {
        if (host == receiver) {
          hangUp();
        }
      }
    }
  }

  private void hangUpIfRefused() {
    if (host != null && !firmware.isOpen()) {
      hangUp();
    }
  }

  /** Call with the lock held. */
  private void hangUp() {
    Socket socket = host;
    host = null;
    firmware.lost();
    lock.notifyAll();
    if (socket != null) {
      close(socket);
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
      hangUp();
      lock.notifyAll();
    }
    close(server);
    try {
      for (Thread thread : new Thread[] {hosts, time, sender}) {
        thread.join();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
