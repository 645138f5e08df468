package org.u2sa.benchmarks.mqtt;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;

/** A bare TCP connection over loopback: what the operating system alone takes. */
final class TcpWay implements Way {
  private static final int BUFFER = 1 << 16;

  private final ServerSocket server; // null: it sends
  private final Socket socket; // null: it listens
  private final Ways.Load load;

  TcpWay(int port, Ways.Load load, Sink sink) throws IOException {
    this.load = load;
    if (sink == null) {
      server = null;
      socket = new Socket(InetAddress.getLoopbackAddress(), port);
      socket.setTcpNoDelay(true);
    } else {
      socket = null;
      server = new ServerSocket();
      server.setReuseAddress(true);
      server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
      Thread reader = new Thread(() -> read(sink), "tcp");
      reader.setDaemon(true);
      reader.start();
    }
  }

  private void read(Sink sink) {
    byte[] message = new byte[load.bytes()];
    try (Socket accepted = server.accept();
        DataInputStream in =
            new DataInputStream(new BufferedInputStream(accepted.getInputStream(), BUFFER))) {
      while (true) {
        in.readFully(message);
        sink.arrived(Contents.sentNanos(ByteBuffer.wrap(message)));
      }
    } catch (EOFException e) {
      return; // the sender has closed
    } catch (IOException e) {
      if (!server.isClosed()) {
        System.err.println("tcp: " + e);
      }
    }
  }

  @Override
  public void send(long sentNanos) throws IOException {
    socket.getOutputStream().write(Contents.bytes(load.bytes(), sentNanos));
  }

  @Override
  public void close() throws IOException {
    if (socket != null) {
      socket.close();
    } else {
      server.close();
    }
  }
}
