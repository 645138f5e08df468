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
 * Exchanges datagrams with a device: one that sends to a port of this machine, or one at a known
 * address. Each datagram's bytes are taken as the next ones of a stream.
 */
final class UdpOpener implements Port.Opener {
  private static final int LARGEST = 65_507;

  private final String host; // empty: whoever sends
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
      throw new IOException("UDP port " + port + " cannot be had (" + e.getMessage() + ")", e);
    }
  }

  private static final class Exchange implements Port {
    private final DatagramSocket socket;
    private final DatagramPacket packet = new DatagramPacket(new byte[LARGEST], LARGEST);
    private final SocketAddress known; // null: whoever sends
    private volatile SocketAddress peer;
    private int taken; // of the packet
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
        return false; // nobody speaks: silence tells that the device is gone
      }
      if (known != null && !known.equals(packet.getSocketAddress())) {
        return false; // a stranger
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
