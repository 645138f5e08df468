package org.u2sa.drivers.link;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.SocketAddress;
import org.u2sa.interfaces.time.SystemClock;

/** A device that answers datagrams to who spoke to it last. */
final class DatagramDevice implements FarEnd {
  private final DatagramSocket socket = new DatagramSocket(0, InetAddress.getLoopbackAddress());
  private final StringBuilder told = new StringBuilder(); // guarded by this
  private SocketAddress peer;
  private boolean isPlugged = true;

  DatagramDevice() throws IOException {
    Thread thread = new Thread(this::listen, "datagram device");
    thread.setDaemon(true);
    thread.start();
  }

  private void listen() {
    DatagramPacket packet = new DatagramPacket(new byte[2048], 2048);
    try {
      while (true) {
        socket.receive(packet);
        synchronized (this) {
          if (isPlugged) {
            peer = packet.getSocketAddress();
            told.append(new String(packet.getData(), 0, packet.getLength(), US_ASCII));
          }
        }
      }
    } catch (IOException e) {
      forget(); // closed
    }
  }

  private synchronized void forget() {
    peer = null;
  }

  @Override
  public String address() {
    return "udp:127.0.0.1:" + socket.getLocalPort() + "?silence=0.5";
  }

  @Override
  public ByteLink open() {
    return ByteLinks.open(address(), new SystemClock());
  }

  @Override
  public synchronized void says(String text) throws IOException {
    if (isPlugged && peer != null) {
      byte[] bytes = text.getBytes(US_ASCII);
      socket.send(new DatagramPacket(bytes, bytes.length, peer));
    }
  }

  @Override
  public synchronized String wasTold() {
    return told.toString();
  }

  @Override
  public synchronized void unplug() {
    isPlugged = false;
  }

  @Override
  public synchronized void plug() {
    isPlugged = true;
  }

  @Override
  public void end() {
    socket.close();
  }
}
