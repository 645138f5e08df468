package org.u2sa.drivers.link;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketAddress;
import java.net.SocketTimeoutException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Exchanges datagrams with a device that sends to a local port, or with one at a known address.
 * Datagram payloads are treated as a byte stream.
 *
 * <p>At a local port, the first sender counts as the device until it falls silent. Datagrams of
 * other senders are ignored, so they cannot divert commands such as an emergency stop.
 */
final class UdpOpener implements Port.Opener {
  private static final int LARGEST = 65_507;

  private final String host; // empty for an unknown one
  private final int port;
  private final boolean hearsAll;
  private final long silenceMicros;

  /**
   * @param host empty: the first sender
   * @param hearsAll whether all senders are read, if no host is given
   * @param silenceS time without a datagram of the first sender after which another may replace it
   *     [s]
   */
  UdpOpener(String host, int port, boolean hearsAll, double silenceS) {
    this.host = host;
    this.port = port;
    this.hearsAll = hearsAll;
    silenceMicros = Clock.micros(silenceS);
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

  private final class Exchange implements Port {
    private final DatagramSocket socket;
    private final DatagramPacket packet = new DatagramPacket(new byte[LARGEST], LARGEST);
    private final SocketAddress known; // null for the first sender
    private final Clock stopwatch = new SystemClock(); // hardware timeouts use real time
    private volatile SocketAddress peer;
    private long heardMicros; // time of the last datagram from the peer
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
      if (!isPeer(packet.getSocketAddress()) && (known != null || !hearsAll)) {
        return false; // a stranger
      }
      length = packet.getLength();
      return length > 0;
    }

    /** Whether the sender is the device; without a device, the sender becomes the device. */
    private boolean isPeer(SocketAddress sender) {
      long now = stopwatch.micros();
      boolean isVacant = peer == null || known == null && now - heardMicros > silenceMicros;
      if (isVacant) {
        peer = sender;
      }
      if (!sender.equals(peer)) {
        return false;
      }
      heardMicros = now;
      return true;
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
