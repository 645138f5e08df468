package org.u2sa.flightgear.link;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.u2sa.flightgear.protocol.LineSplitter;
import org.u2sa.flightgear.protocol.MalformedLineException;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;

/**
 * Server side of FlightGear's output. The first peer to send a valid line while no other does is
 * taken to be FlightGear, so neither a stray nor a dead connection blocks the real one. Confined to
 * the link's thread.
 */
final class OutChannel {
  static final long SILENCE_MICROS = Clock.MICROS_PER_SECOND;

  private static final int MAX_PEERS = 4;

  private final Clock clock;
  private final Troubles troubles;
  private final ServerSocketChannel server;
  private final MeasuringTime time = new MeasuringTime();
  private final Set<Peer> peers = new LinkedHashSet<>();
  private final ByteBuffer buffer = ByteBuffer.allocate(16_384);
  private Peer flightGear;
  private AircraftReading newest = AircraftReading.none();
  private long lastLineMicros;
  private long count;
  private boolean silent;
  private boolean everConnected;

  OutChannel(FlightGearAddress address, Selector selector, Clock clock, Troubles troubles) {
    this.clock = clock;
    this.troubles = troubles;
    this.server = listen(address, selector);
  }

  private static ServerSocketChannel listen(FlightGearAddress address, Selector selector) {
    try {
      ServerSocketChannel server = ServerSocketChannel.open();
      try {
        server.setOption(
            StandardSocketOptions.SO_REUSEADDR,
            true); // otherwise the port stays in TIME_WAIT for a minute after a run
        server.bind(new InetSocketAddress(address.bindHost(), address.outPort()));
        server.configureBlocking(false);
        server.register(selector, SelectionKey.OP_ACCEPT);
        return server;
      } catch (IOException | RuntimeException e) {
        server.close();
        throw e;
      }
    } catch (IOException | RuntimeException e) { // an unresolvable host is not an IOException
      throw new CommunicationException(
          "cannot listen for FlightGear on "
              + address.bindHost()
              + ":"
              + address.outPort()
              + " ("
              + e.getMessage()
              + "): end the program that holds the port, or give this one and FlightGear another out-port",
          e);
    }
  }

  int port() {
    return server.socket().getLocalPort();
  }

  void accept(Selector selector) throws IOException {
    SocketChannel channel = server.accept();
    if (channel == null) {
      return;
    }
    if (peers.size() == MAX_PEERS) {
      peers.stream().filter(peer -> peer != flightGear).findFirst().ifPresent(this::close);
    }
    channel.configureBlocking(false);
    Peer peer = new Peer(channel);
    peers.add(peer);
    channel.register(selector, SelectionKey.OP_READ, peer);
  }

  /** Handles bytes received from a peer. */
  void read(Peer peer) {
    try {
      buffer.clear();
      int got = peer.channel.read(buffer);
      if (got < 0) {
        lost(peer, "FlightGear closed the connection of its lines");
        return;
      }
      buffer.flip();
      if (got > 0 && !peer.began && !isStartOfNumber(buffer.get(0))) {
        troubles.event(peer.name + " was closed: it began with no number, unlike FlightGear");
        close(peer);
        return;
      }
      peer.began |= got > 0;
      peer.lines.feed(buffer, line -> take(peer, line), start -> tooLong(peer));
    } catch (IOException e) {
      lost(peer, "FlightGear's lines broke off: " + e.getMessage());
    }
  }

  /** A web page of a browser on this host can send lines of numbers, but only behind a header. */
  private static boolean isStartOfNumber(byte first) {
    return first == '-' || first >= '0' && first <= '9';
  }

  private void tooLong(Peer peer) {
    troubles.refusedLine("longer than " + LineSplitter.LONGEST + " bytes, from " + peer.name);
  }

  private void take(Peer peer, String text) {
    if (!peers.contains(peer)) {
      return; // closed by an earlier line of the same packet
    }
    OutLine line;
    try {
      line = OutLine.parse(text);
    } catch (MalformedLineException e) {
      troubles.refusedLine(e.getMessage() + ", from " + peer.name);
      return;
    }
    long now = clock.micros();
    if (peer != flightGear && !adopt(peer, now)) {
      return;
    }
    if (silent) {
      silent = false;
      troubles.event(
          String.format(
              Locale.ROOT,
              "FlightGear's lines resumed after %.1f s",
              Clock.seconds(now - lastLineMicros)));
    }
    lastLineMicros = now;
    if (!line.isBeforeFlight()) {
      count = Math.round(line.get(OutField.COUNT));
      if (time.take(line.get(OutField.ELAPSED), now)) {
        read(line, peer);
      }
    }
  }

  private void read(OutLine line, Peer peer) {
    try {
      newest = Readings.of(line, newest.sequence() + 1, time.micros());
    } catch (IllegalArgumentException e) { // must not end the link
      troubles.refusedLine(e.getMessage() + ", from " + peer.name);
    }
  }

  private boolean adopt(Peer peer, long now) {
    if (flightGear != null && !silent && now - lastLineMicros <= SILENCE_MICROS) {
      troubles.event(
          "a second sender of lines, "
              + peer.name
              + ", was refused: "
              + flightGear.name
              + " is connected");
      close(peer);
      return false;
    }
    if (flightGear != null) {
      close(flightGear);
    }
    flightGear = peer;
    silent = false;
    troubles.event(
        "FlightGear "
            + (everConnected ? "is connected again" : "connected")
            + " from "
            + peer.name);
    everConnected = true;
    return true;
  }

  private void lost(Peer peer, String what) {
    boolean inside = peer.lines.isInsideLine();
    close(peer);
    if (peer == flightGear) {
      flightGear = null;
      troubles.event(what + (inside ? " in the middle of a line" : ""));
    }
  }

  /** Detects silence. */
  void tick(long nowMicros) {
    if (flightGear != null && !silent && nowMicros - lastLineMicros > SILENCE_MICROS) {
      silent = true;
      troubles.event("FlightGear has been silent for more than 1 s");
    }
  }

  /**
   * The newest reading; empty while FlightGear is disconnected or silent, or before its flight
   * model runs.
   */
  Optional<AircraftReading> reading() {
    return flightGear != null && !silent && newest.sequence() > 0
        ? Optional.of(newest)
        : Optional.empty();
  }

  /** The newest reading ever received. */
  AircraftReading newest() {
    return newest;
  }

  /** Arrival time of the newest valid line [µs]. */
  long lastLineMicros() {
    return lastLineMicros;
  }

  /** Number of the newest line that FlightGear has received from this program. */
  long count() {
    return count;
  }

  boolean hasPeer() {
    return !peers.isEmpty();
  }

  boolean everConnected() {
    return everConnected;
  }

  private void close(Peer peer) {
    peers.remove(peer);
    troubles.close(peer.channel);
  }

  void close() {
    peers.forEach(peer -> troubles.close(peer.channel));
    peers.clear();
    flightGear = null;
    troubles.close(server);
  }

  /** One connection. */
  static final class Peer {
    private final SocketChannel channel;
    private final LineSplitter lines = new LineSplitter();
    private final String name;
    private boolean began; // has sent its first byte

    private Peer(SocketChannel channel) throws IOException {
      this.channel = channel;
      this.name = String.valueOf(channel.getRemoteAddress()).replace("/", "");
    }
  }
}
