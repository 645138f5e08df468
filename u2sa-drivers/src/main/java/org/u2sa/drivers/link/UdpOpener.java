package org.u2sa.drivers.link;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketAddress;
import java.net.SocketTimeoutException;

/**
 * Exchanges datagrams with a device that sends to a local port, or with one at a known address.
 * Datagram payloads are treated as a byte stream.
 */
final class UdpOpener implements Port.Opener {
  private static final int LARGEST = 65_507;

  private final String host; // empty for any sender
  private final int port;

  UdpOpener(String host, int port) {
    this.host = host;
    this.port = port;
  }

  @Override
  public Port open() throws IOException {
    if (host.isEmpty()) {
      return new Exchange(listening(), null);
    }
    InetSocketAddress peer = new InetSocketAddress(InetAddress.getByName(host), port);
    return new Exchange(new DatagramSocket(), peer);
  }

  private DatagramSocket listening() throws IOException {
    try {
      return new DatagramSocket(port);
    } catch (IOException e) {
      throw new IOException("UDP port " + port + " cannot be opened (" + e.getMessage() + ")", e);
    }
  }

  private static final class Exchange implements Port {
    private final DatagramSocket socket;
    private final DatagramPacket packet = new DatagramPacket(new byte[LARGEST], LARGEST);
    private final SocketAddress known; // null for any sender
    private volatile SocketAddress peer;
    private int taken; // bytes consumed of the packet
    private int length;

    Exchange(DatagramSocket socket, SocketAddress known) throws IOException {
      this.socket = socket;
      this.known = known;
      peer = known;
      socket.setSoTimeout(PATIENCE_MS);
    }

    @Override
    public int read(byte[] buffer) throws IOException {
      if (taken == length && !receive()) {
        return 0;
      }
      int count = Math.min(buffer.length, length - taken);
      System.arraycopy(packet.getData(), taken, buffer, 0, count);
      taken += count;
      return count;
    }

    private boolean receive() throws IOException {
      taken = 0;
      length = 0;
      packet.setLength(LARGEST);
      try {
        socket.receive(packet);
      } catch (SocketTimeoutException | PortUnreachableException e) {
        return false; // no sender yet: presence is known only from received data
      }
      if (known != null && !known.equals(packet.getSocketAddress())) {
        return false; // unknown sender
      }
      peer = packet.getSocketAddress();
      length = packet.getLength();
      return length > 0;
    }

    @Override
    public boolean isWritable() {
      return peer != null;
    }

    @Override
    public boolean isFoundBySpeaking() {
      return true;
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      SocketAddress to = peer;
      if (to != null) {
        socket.send(new DatagramPacket(bytes, bytes.length, to));
      }
    }

    @Override
    public void close() {
      socket.close();
    }
  }
}
