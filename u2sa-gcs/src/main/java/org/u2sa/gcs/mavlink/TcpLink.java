package org.u2sa.gcs.mavlink;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Supplier;
import org.u2sa.mavlink.MavlinkStream;

/**
 * Stations that connect by TCP. One that does not read is disconnected. If all places are taken, a
 * new station replaces the oldest connection that has sent no valid packet, so silent clients and
 * clients without the key cannot lock operators out. One that begins with anything but a packet is
 * disconnected: a page in a browser of this host can send an HTTP request to any port, with packets
 * in its body.
 */
final class TcpLink implements StationLink {
  private static final int MAX_STATIONS = 16;
  private static final long STUCK_MICROS = 10_000_000;

  /** A connected station. */
  private static final class Peer {
    private final SocketChannel channel;
    private final StationSession session;
    private boolean began; // has sent its first byte
    private ByteBuffer unsent = ByteBuffer.allocate(0);
    private long wroteMicros;

    Peer(SocketChannel channel, StationSession session, long nowMicros) {
      this.channel = channel;
      this.session = session;
      wroteMicros = nowMicros;
    }

    /** Reads; the end if it begins with anything but a packet. */
    private int read(byte[] bytes) throws IOException {
      int length = channel.read(ByteBuffer.wrap(bytes));
      if (length > 0 && !began && !MavlinkStream.isMagic(bytes[0])) {
        return -1;
      }
      began |= length > 0;
      return length;
    }

    private void close() throws IOException {
      session.close();
      channel.close();
    }
  }

  private final ServerSocketChannel server;
  private final Selector selector;
  private final Supplier<StationSession> sessions;
  private final List<Peer> peers = new ArrayList<>();
  private final StationReader reader = new StationReader();

  TcpLink(InetSocketAddress address, Supplier<StationSession> sessions, Selector selector)
      throws IOException {
    this.sessions = sessions;
    this.selector = selector;
    server = ServerSocketChannel.open();
    server.setOption(StandardSocketOptions.SO_REUSEADDR, true);
    server.bind(address);
    server.configureBlocking(false);
    server.register(selector, SelectionKey.OP_ACCEPT);
  }

  @Override
  public void exchange(long nowMicros) throws IOException {
    Iterator<Peer> all = peers.iterator();
    while (all.hasNext()) {
      Peer peer = all.next();
      if (!isAlive(peer, nowMicros)) {
        peer.close();
        all.remove();
      }
    }
    try {
      accept(nowMicros); // last: packets of connected stations are handled first
    } catch (IOException e) {
      // No free file descriptor, or the station has already left; connected stations are
      // unaffected.
    }
  }

  private void accept(long nowMicros) throws IOException {
    SocketChannel channel = server.accept();
    if (channel == null) {
      return;
    }
    if (!hasPlace()) {
      channel.close();
      return;
    }
    channel.configureBlocking(false);
    channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
    channel.register(selector, SelectionKey.OP_READ);
    peers.add(new Peer(channel, sessions.get(), nowMicros));
  }

  private boolean hasPlace() throws IOException {
    for (int i = 0; i < peers.size() && peers.size() >= MAX_STATIONS; i++) {
      if (!peers.get(i).session.isHeard()) { // oldest first
        peers.remove(i).close();
      }
    }
    return peers.size() < MAX_STATIONS;
  }

  private boolean isAlive(Peer peer, long nowMicros) {
    try {
      return read(peer, nowMicros) && write(peer, nowMicros);
    } catch (IOException e) {
      return false; // reset by the station
    }
  }

  private boolean read(Peer peer, long nowMicros) throws IOException {
    boolean goesOn = reader.read(peer::read, peer.session, nowMicros);
    SelectionKey key = peer.channel.keyFor(selector);
    key.interestOps(peer.session.isOpen(nowMicros) ? SelectionKey.OP_READ : 0); // else every turn
    return goesOn;
  }

  private boolean write(Peer peer, long nowMicros) throws IOException {
    while (true) {
      if (!peer.unsent.hasRemaining()) {
        byte[] packet = peer.session.poll();
        if (packet == null) {
          peer.wroteMicros = nowMicros;
          return true;
        }
        peer.unsent = ByteBuffer.wrap(packet);
      }
      if (peer.channel.write(peer.unsent) == 0) {
        return nowMicros - peer.wroteMicros < STUCK_MICROS;
      }
      peer.wroteMicros = nowMicros;
    }
  }

  @Override
  public Iterable<StationSession> sessions() {
    return peers.stream().map(peer -> peer.session).toList();
  }

  /** Port on which it listens. */
  int port() throws IOException {
    return ((InetSocketAddress) server.getLocalAddress()).getPort();
  }

  @Override
  public void close() throws IOException {
    for (Peer peer : peers) {
      peer.close();
    }
    server.close();
  }
}
