package org.u2sa.drivers.link;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Arrays;

/**
 * Puts a simulated device at a TCP port, in real time: what comes is written to the link at whose
 * other end the device is, and what the device says goes out. Can be unplugged; keeps its port.
 */
public final class DeviceServer implements AutoCloseable {
  private static final int TURN_MS = 5;

  private final MemoryLink device;
  private ServerSocket server; // guarded by this
  private Socket client; // guarded by this; null: none
  private int port;

  /** At a port that was free. */
  public DeviceServer(MemoryLink device) throws IOException {
    this.device = device;
    plug();
  }

  /** Where the device is: "tcp:127.0.0.1:PORT". */
  public synchronized String address() {
    return "tcp:127.0.0.1:" + port;
  }

  /** Comes back at the same port. */
  public synchronized void plug() throws IOException {
    server = new ServerSocket();
    server.setReuseAddress(true);
    server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    port = server.getLocalPort();
    ServerSocket accepting = server;
    Thread thread = new Thread(() -> serve(accepting), "simulated device at " + port);
    thread.setDaemon(true);
    thread.start();
  }

  /** Goes away in the middle of whatever it says. */
  public synchronized void unplug() throws IOException {
    server.close();
    if (client != null) {
      client.close();
    }
  }

  private void serve(ServerSocket accepting) {
    while (!accepting.isClosed()) {
      try (Socket accepted = accepting.accept()) {
        synchronized (this) {
          client = accepted;
        }
        accepted.setSoTimeout(TURN_MS);
        pump(accepted);
      } catch (IOException e) {
        continue; // unplugged, or the host hung up: the next one may come
      }
    }
  }

  private void pump(Socket with) throws IOException {
    byte[] buffer = new byte[4096];
    while (true) {
      int count = hear(with.getInputStream(), buffer);
      if (count < 0) {
        return;
      }
      if (count > 0) {
        device.write(Arrays.copyOf(buffer, count));
      }
      while ((count = device.read(buffer)) > 0) {
        with.getOutputStream().write(buffer, 0, count);
      }
    }
  }

  private static int hear(InputStream in, byte[] buffer) throws IOException {
    try {
      return in.read(buffer);
    } catch (SocketTimeoutException e) {
      return 0; // nothing is said just now
    }
  }

  @Override
  public void close() throws IOException {
    unplug();
  }
}
