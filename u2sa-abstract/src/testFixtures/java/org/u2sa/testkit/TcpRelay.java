package org.u2sa.testkit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;

/** A wire between a client and a broker that a test can cut, or let go dead without a word. */
public final class TcpRelay implements AutoCloseable {
  private final int target;
  private final ServerSocket entry;
  private final List<Socket> sockets = new CopyOnWriteArrayList<>();
  private final ReentrantLock lock = new ReentrantLock();
  private final Condition alive = lock.newCondition();
  private boolean dead; // under lock: bytes wait in the wire
  private volatile boolean cut;
  private final AtomicInteger connections = new AtomicInteger();

  /**
   * @param target port of this host to which it leads
   */
  public TcpRelay(int target) throws IOException {
    this.target = target;
    entry = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    daemon(this::accept);
  }

  /** The port that clients connect to. */
  public int port() {
    return entry.getLocalPort();
  }

  /** How many connections have come. */
  public int connections() {
    return connections.get();
  }

  /** Breaks all connections and lets none through. */
  public void cut() {
    cut = true;
    breakAll();
  }

  /** Lets connections through again; what hung before is broken, as a router does that forgot. */
  public void restore() {
    breakAll();
    cut = false;
    lock.lock();
    try {
      dead = false;
      alive.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** From now on nothing arrives, and nobody is told. */
  public void goDead() {
    lock.lock();
    dead = true;
    lock.unlock();
  }

  private void breakAll() {
    sockets.forEach(TcpRelay::quietly);
    sockets.clear();
  }

  private static void quietly(AutoCloseable socket) {
    try {
      socket.close();
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
  }

  private static void daemon(Runnable task) {
    Thread thread = new Thread(task, "test-relay");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!entry.isClosed()) {
      try {
        Socket client = entry.accept();
        connections.incrementAndGet();
        if (cut) {
          client.close();
          continue;
        }
        sockets.add(client);
        awaitLife();
        Socket broker = new Socket(InetAddress.getLoopbackAddress(), target);
        client.setTcpNoDelay(true);
        broker.setTcpNoDelay(true);
        sockets.add(broker);
        daemon(() -> pump(client, broker));
        daemon(() -> pump(broker, client));
      } catch (IOException e) {
        continue; // the broker is away, or the test is over
      }
    }
  }

  private void pump(Socket from, Socket to) {
    byte[] buffer = new byte[8_192];
    try (from;
        to) {
      for (int n = from.getInputStream().read(buffer);
          n >= 0;
          n = from.getInputStream().read(buffer)) {
        awaitLife();
        to.getOutputStream().write(buffer, 0, n);
      }
    } catch (IOException e) {
      return; // cut
    }
  }

  private void awaitLife() throws IOException {
    lock.lock();
    try {
      while (dead) {
        alive.await();
      }
    } catch (InterruptedException e) {
      throw new IOException(e);
    } finally {
      lock.unlock();
    }
  }

  @Override
  public void close() {
    try {
      entry.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    breakAll();
  }
}
