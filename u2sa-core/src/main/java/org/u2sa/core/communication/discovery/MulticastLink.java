package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.DatagramPacket;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.MulticastSocket;
import java.net.NetworkInterface;
import java.net.SocketTimeoutException;
import java.util.Optional;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.interfaces.time.Clock;

/**
 * Multicast DNS on one network. Anybody there may send anything, so messages are read at a limited
 * rate and never stored; the operating system drops the excess. Never replies by unicast, so that
 * nobody can have a forged address flooded.
 */
final class MulticastLink implements AutoCloseable {
  private static final int PORT = 5353;
  private static final String GROUP = "224.0.0.251";
  private static final int HOPS = 255; // RFC 6762, 11
  private static final double MESSAGES_PER_S = 200.0;
  private static final long PAUSE_MICROS = 100_000;
  private static final long MILLISECOND_MICROS = 1_000;
  private static final long LONGEST_WAIT_MS = 1_000;

  private final Clock clock;
  private final Clock.Waiter pause;
  private final Allowance allowance;
  private final InetSocketAddress group;
  private final MulticastSocket socket;
  private final byte[] buffer = new byte[DnsMessage.LONGEST];

  /**
   * @param network this host's address on it
   * @param clock real time
   */
  MulticastLink(InetAddress network, Clock clock) throws IOException {
    this.clock = clock;
    allowance = new Allowance(MESSAGES_PER_S, clock.micros());
    group = new InetSocketAddress(InetAddress.getByName(GROUP), PORT);
    NetworkInterface through = NetworkInterface.getByInetAddress(network);
    if (through == null) {
      throw new IOException("no network of this host has that address");
    }
    socket = new MulticastSocket(PORT); // shared with other programs
    try {
      socket.setNetworkInterface(through);
      socket.setTimeToLive(HOPS);
      socket.joinGroup(group, through);
    } catch (IOException e) {
      socket.close();
      throw e;
    }
    pause = clock.newWaiter("u2sa-mdns");
  }

  void send(DnsMessage message) throws IOException {
    byte[] bytes = message.bytes();
    socket.send(new DatagramPacket(bytes, bytes.length, group));
  }

  /**
   * Waits up to a second for a message.
   *
   * @return empty after the deadline, or if the message cannot be read
   * @throws IOException if this is closed
   */
  Optional<DnsMessage> receive(long deadlineMicros) throws IOException, InterruptedException {
    long now = clock.micros();
    if (!allowance.isOpen(now)) {
      pause.await(now + PAUSE_MICROS);
      return Optional.empty();
    }
    long waitMs = Math.min(LONGEST_WAIT_MS, (deadlineMicros - now) / MILLISECOND_MICROS);
    socket.setSoTimeout((int) Math.max(1, waitMs)); // 0 0 would wait forever
    DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
    try {
      socket.receive(packet);
    } catch (SocketTimeoutException e) {
      return Optional.empty();
    }
    allowance.take(1.0);
    return read(packet);
  }

  private static Optional<DnsMessage> read(DatagramPacket packet) {
    try {
      return Optional.of(DnsMessage.read(packet.getData(), packet.getLength()));
    } catch (IOException e) {
      return Optional.empty(); // malformed
    }
  }

  boolean isClosed() {
    return socket.isClosed();
  }

  @Override
  public void close() {
    socket.close();
    pause.close();
  }
}
