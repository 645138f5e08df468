package org.u2sa.flightgear.link;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Connection that carries controls to FlightGear. It connects only when there is something to send
 * and closes only after a complete line, because otherwise FlightGear's channel stops working. Only
 * the newest controls are sent. Confined to the link's thread.
 */
final class InChannel {
  static final long SPACING_MICROS = 20_000; // FlightGear reads at 20 to 60 Hz

  private static final long SHORTEST_PAUSE_MICROS = 100_000;
  private static final long LONGEST_PAUSE_MICROS = 2 * Clock.MICROS_PER_SECOND;
  private static final long PATIENCE_MICROS = 2 * Clock.MICROS_PER_SECOND;

  private final FlightGearAddress address;
  private final Clock clock;
  private final Troubles troubles;
  private SocketChannel channel;
  private SelectionKey key;
  private boolean open;
  private InLine last = InLine.nothing();
  private ByteBuffer pending = ByteBuffer.allocate(0);
  private long sentMicros;
  private long sinceMicros; // connecting since, or waiting for FlightGear to read
  private long retryMicros;
  private long pauseMicros = SHORTEST_PAUSE_MICROS;
  private boolean failing;
  private boolean stuck;

  InChannel(FlightGearAddress address, Clock clock, Troubles troubles) {
    this.address = address;
    this.clock = clock;
    this.troubles = troubles;
  }

  /** Connects if a connection is due. */
  void connect(Selector selector, long nowMicros) {
    if (channel != null || nowMicros < retryMicros) {
      return;
    }
    try {
      channel = SocketChannel.open();
      channel.configureBlocking(false);
      channel.setOption(StandardSocketOptions.TCP_NODELAY, true);
      sinceMicros = nowMicros;
      open = channel.connect(new InetSocketAddress(address.host(), address.inPort()));
      key = channel.register(selector, open ? SelectionKey.OP_READ : SelectionKey.OP_CONNECT, this);
      if (open) {
        opened();
      }
    } catch (IOException | RuntimeException e) { // an unresolvable host is not an IOException
      failed(e.getMessage() == null ? e.getClass().getSimpleName() : e.getMessage());
    }
  }

  /** Handles a ready selection key. */
  void ready(SelectionKey selected) {
    try {
      if (selected.isConnectable() && channel.finishConnect()) {
        open = true;
        opened();
      }
      if (open && selected.isReadable() && channel.read(ByteBuffer.allocate(256)) < 0) {
        failed("FlightGear closed the connection");
        return;
      }
      if (open) {
        flush();
      }
    } catch (IOException e) {
      failed(e.getMessage());
    }
  }

  private void opened() {
    key.interestOps(SelectionKey.OP_READ);
    pending = ByteBuffer.allocate(0); // discard the rest of a line begun on the previous connection
    sinceMicros = clock.micros();
    sentMicros = sinceMicros - SPACING_MICROS;
  }

  /**
   * Sends controls, unless the previous line is still being written or was sent less than {@link
   * #SPACING_MICROS} ago.
   *
   * @return whether they are being sent
   */
  boolean send(ControlInputs controls, long nowMicros) {
    if (!isFree() || nowMicros - sentMicros < SPACING_MICROS) {
      return false;
    }
    last = last.next(controls);
    pending = ByteBuffer.wrap((last.format() + "\n").getBytes(StandardCharsets.US_ASCII));
    sentMicros = nowMicros;
    sinceMicros = nowMicros;
    try {
      flush();
    } catch (IOException e) {
      failed(e.getMessage());
    }
    return open;
  }

  private void flush() throws IOException {
    if (pending.hasRemaining()) {
      channel.write(pending);
    }
    key.interestOps(
        pending.hasRemaining()
            ? SelectionKey.OP_READ | SelectionKey.OP_WRITE
            : SelectionKey.OP_READ);
    if (!pending.hasRemaining()) {
      if (failing || stuck) {
        troubles.event("controls go to FlightGear again");
      }
      failing = false;
      stuck = false;
      pauseMicros = SHORTEST_PAUSE_MICROS;
    }
  }

  /** Times out connections and writes. */
  void tick(long nowMicros) {
    if (channel == null || nowMicros - sinceMicros < PATIENCE_MICROS) {
      return;
    }
    if (!open) {
      failed("no answer");
    } else if (pending.hasRemaining() && !stuck) {
      stuck = true; // left open: FlightGear would never listen again after half a line
      troubles.event("FlightGear does not read its controls");
    }
  }

  private void failed(String why) {
    if (!failing) {
      failing = true;
      troubles.event(
          "controls do not reach FlightGear at "
              + address.host()
              + ":"
              + address.inPort()
              + ": "
              + why
              + "; trying again");
    }
    drop();
    retryMicros = clock.micros() + pauseMicros;
    pauseMicros = Math.min(LONGEST_PAUSE_MICROS, 2 * pauseMicros);
  }

  /** Closes the connection; {@link #connect} opens another. */
  void drop() {
    retryMicros = 0;
    if (channel != null) {
      troubles.close(channel);
    }
    channel = null;
    open = false;
    pending = ByteBuffer.allocate(0);
  }

  /** Whether the next line can be sent. */
  boolean isFree() {
    return open && !pending.hasRemaining();
  }

  /** Whether a line is being written. */
  boolean isBusy() {
    return open && pending.hasRemaining();
  }

  /** Earliest time of the next line [µs]. */
  long nextMicros() {
    return sentMicros + SPACING_MICROS;
  }
}
