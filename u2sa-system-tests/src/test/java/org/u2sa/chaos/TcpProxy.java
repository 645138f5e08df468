package org.u2sa.chaos;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;

/** A network that can break: every MQTT client reaches the broker through it. */
final class TcpProxy implements Closeable {
  private static final int CHUNK = 16_384;

  private final ServerSocket listener;
  private final int targetPort;
  private final Set<Link> links = ConcurrentHashMap.newKeySet();
  private volatile boolean refusing;

  TcpProxy(int targetPort) throws IOException {
    this.targetPort = targetPort;
    listener = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    start("proxy-accept", this::accept);
  }

  int port() {
    return listener.getLocalPort();
  }

  /** Breaks the connections whose MQTT client ID is one of these: both ends see a reset. */
  void cut(Predicate<String> clientIds) {
    of(clientIds).forEach(Link::reset);
  }

  /** From now on new connections are broken at once, or no longer. */
  void refuse(boolean refuse) {
    refusing = refuse;
  }

  /** Holds back every byte of these connections, or lets them go on; neither end sees an error. */
  void stall(Predicate<String> clientIds, boolean stall) {
    of(clientIds).forEach(link -> link.stall(stall));
  }

  /** Puts bytes into the middle of what these clients send. */
  void inject(Predicate<String> clientIds, byte[] bytes) {
    of(clientIds).forEach(link -> link.inject(bytes));
  }

  private List<Link> of(Predicate<String> clientIds) {
    return links.stream().filter(link -> clientIds.test(link.clientId)).toList();
  }

  private void accept() {
    while (!listener.isClosed()) {
      try {
        Socket client = listener.accept();
        if (refusing) {
          reset(client);
        } else {
          open(client);
        }
      } catch (IOException e) {
        if (!listener.isClosed()) {
          throw new IllegalStateException("the proxy can accept no more connections", e);
        }
      }
    }
  }

  private void open(Socket client) {
    try {
      Socket server = new Socket(InetAddress.getLoopbackAddress(), targetPort);
      client.setTcpNoDelay(true);
      server.setTcpNoDelay(true);
      Link link = new Link(client, server);
      links.add(link);
      start("proxy-up", () -> link.pump(client, server, true));
      start("proxy-down", () -> link.pump(server, client, false));
    } catch (IOException e) {
      reset(client); // the broker is away, and the client learns it as it would without a proxy
    }
  }

  private static void start(String name, Runnable work) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
  }

  private static void reset(Socket socket) {
    try {
      socket.setSoLinger(true, 0);
      socket.close();
    } catch (IOException e) {
      if (!socket.isClosed()) { // by the other direction's pump
        throw new IllegalStateException("a socket cannot be closed", e);
      }
    }
  }

  @Override
  public void close() throws IOException {
    listener.close();
    links.forEach(Link::reset);
  }

  /** One client's connection, in both directions. */
  private final class Link {
    private final Socket client;
    private final Socket server;
    private volatile String clientId = "";
    private boolean stalled;

    Link(Socket client, Socket server) {
      this.client = client;
      this.server = server;
    }

    void pump(Socket from, Socket to, boolean fromClient) {
      byte[] chunk = new byte[CHUNK];
      try (InputStream in = from.getInputStream()) {
        for (int size = in.read(chunk); size >= 0; size = in.read(chunk)) {
          if (fromClient && clientId.isEmpty()) {
            clientId = MqttConnect.clientId(chunk, size);
          }
          awaitGo();
          synchronized (to) {
            to.getOutputStream().write(chunk, 0, size);
          }
        }
      } catch (IOException e) {
        // Either end broke it, or we did: the other end is to see the same.
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } finally {
        reset();
      }
    }

    private synchronized void awaitGo() throws InterruptedException {
      while (stalled) {
        wait();
      }
    }

    synchronized void stall(boolean stall) {
      stalled = stall;
      notifyAll();
    }

    void inject(byte[] bytes) {
      try {
        synchronized (server) {
          OutputStream out = server.getOutputStream();
          out.write(bytes);
        }
      } catch (IOException e) {
        reset();
      }
    }

    synchronized void reset() {
      links.remove(this);
      stall(false);
      TcpProxy.reset(client);
      TcpProxy.reset(server);
    }
  }
}
