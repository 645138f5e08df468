package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;

/** A device server that can be unplugged: takes one connection at a time, keeps its port. */
final class SocketDevice {
  private final InetAddress address;
  private final ByteArrayOutputStream told = new ByteArrayOutputStream();
  private int port;
  private ServerSocket server;
  private Socket client;

  SocketDevice(InetAddress address) throws IOException {
    this.address = address;
    plug();
  }

  synchronized int port() {
    return port;
  }

  synchronized void plug() throws IOException {
    server = new ServerSocket();
    server.setReuseAddress(true);
    server.bind(new InetSocketAddress(address, port));
    port = server.getLocalPort();
    ServerSocket accepting = server;
    Thread thread = new Thread(() -> serve(accepting), "device server " + port);
    thread.setDaemon(true);
    thread.start();
  }

  private void serve(ServerSocket accepting) {
    try {
      while (!accepting.isClosed()) {
        Socket accepted = accepting.accept();
        synchronized (this) {
          client = accepted;
        }
        listen(accepted);
      }
    } catch (IOException e) {
      unplugQuietly(); // unplugged
    }
  }

  private void listen(Socket accepted) {
    byte[] buffer = new byte[1024];
    try (InputStream in = accepted.getInputStream()) {
      for (int count = in.read(buffer); count >= 0; count = in.read(buffer)) {
        synchronized (this) {
          told.write(buffer, 0, count);
        }
      }
    } catch (IOException e) {
      unplugClient(accepted); // gone
    }
  }

  private synchronized void unplugClient(Socket gone) {
    if (client == gone) {
      client = null;
    }
  }

  private synchronized void unplugQuietly() {
    client = null;
  }

  synchronized void says(String text) {
    if (client != null) {
      try {
        client.getOutputStream().write(text.getBytes(US_ASCII));
      } catch (IOException e) {
        client = null; // nobody listens
      }
    }
  }

  synchronized String wasTold() {
    return told.toString(US_ASCII);
  }

  synchronized void unplug() throws IOException {
    server.close();
    if (client != null) {
      client.close();
      client = null;
    }
  }
}
