package org.u2sa.flightgear.link;

import java.io.IOException;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.concurrent.atomic.AtomicReference;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * The thread of a {@link FlightGearLink}. It reads FlightGear's lines without delay, because
 * FlightGear freezes if nobody reads, sends the newest controls, and detects and repairs lost
 * connections.
 */
final class FlightGearThread extends Thread {
  private static final long TURN_MS = 50;
  private static final long RESEND_MICROS = 250_000;
  private static final long DEAF_MICROS = 1_500_000;
  private static final long LAST_LINE_MICROS = 500_000;
  private static final long GONE_MICROS = 300_000;
  private static final long NEVER_CAME_MICROS =
      1_500_000; // FlightGear connects 1.4 s after its start
  private static final long MUTE_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private final Clock clock;
  private final Troubles troubles;
  private final Selector selector;
  private final OutChannel out;
  private final InChannel in;
  private final Repair repair;
  private final AtomicReference<ControlInputs> wanted = new AtomicReference<>();
  private volatile Seen seen = new Seen(AircraftReading.none(), false, 0);
  private volatile boolean closing;
  private volatile boolean there; // a peer is connected and sends lines
  private ControlInputs latest;
  private long sentMicros;
  private long heardCount;
  private long heardMicros; // last time FlightGear echoed a new count, or could not be expected to
  private boolean deaf;
  private long peerMicros; // last time a peer was connected

  /** Snapshot for readers. */
  record Seen(AircraftReading reading, boolean alive, long lastLineMicros) {}

  FlightGearThread(FlightGearAddress address, Clock clock, Troubles troubles) {
    super("flightgear-link");
    setDaemon(true);
    this.clock = clock;
    this.troubles = troubles;
    this.selector = open();
    this.out = listen(address);
    this.in = new InChannel(address, clock, troubles);
    this.repair = new Repair(address, troubles);
    this.peerMicros = clock.micros();
  }

  private static Selector open() {
    try {
      return Selector.open();
    } catch (IOException e) {
      throw new CommunicationException("no more connections can be opened: " + e.getMessage(), e);
    }
  }

  private OutChannel listen(FlightGearAddress address) {
    try {
      return new OutChannel(address, selector, clock, troubles);
    } catch (CommunicationException e) {
      troubles.close(selector);
      throw e;
    }
  }

  int port() {
    return out.port();
  }

  Seen seen() {
    return seen;
  }

  void want(ControlInputs controls) {
    wanted.set(controls);
    selector.wakeup();
  }

  /** Sends pending controls, then ends. */
  void end() {
    closing = true;
    selector.wakeup();
  }

  @Override
  public void run() {
    try {
      while (!closing) {
        turn();
      }
      long deadline = clock.micros() + LAST_LINE_MICROS;
      while ((in.isBusy() || in.isFree() && wanted.get() != null) && clock.micros() < deadline) {
        turn();
      }
    } catch (IOException
        | RuntimeException e) { // reported to the service, which continues without an aircraft
      troubles.event("the link to FlightGear ended with an error: " + e);
    } finally {
      seen = new Seen(seen.reading(), false, seen.lastLineMicros());
      out.close();
      in.drop();
      troubles.close(selector);
    }
  }

  private void turn() throws IOException {
    selector.select(this::ready, patienceMs(clock.micros()));
    long now = clock.micros();
    out.tick(now);
    in.tick(now);
    repair.tick(now);
    boolean flying = out.reading().isPresent();
    seen = new Seen(out.newest(), flying, out.lastLineMicros());
    if (flying && !closing && !repair.isBusy() && (latest != null || wanted.get() != null)) {
      in.connect(selector, now);
    }
    send(now);
    listenForEcho(flying, now);
    callFlightGear(now);
  }

  private long patienceMs(long now) {
    boolean due = wanted.get() != null && in.isFree();
    return due ? Math.max(1, (in.nextMicros() - now) / 1_000) : TURN_MS;
  }

  private void ready(SelectionKey key) {
    if (!key.isValid()) {
      return;
    }
    if (key.isAcceptable()) {
      accept();
    } else if (key.attachment() instanceof OutChannel.Peer peer) {
      out.read(peer);
    } else {
      in.ready(key);
    }
  }

  private void accept() {
    try {
      out.accept(selector);
    } catch (IOException e) {
      troubles.event("a connection to the out-port failed: " + e.getMessage());
    }
  }

  private void send(long now) {
    if (!in.isFree() || now < in.nextMicros()) {
      return;
    }
    ControlInputs controls = wanted.getAndSet(null);
    if (controls != null) {
      latest = controls;
    }
    if (latest != null && (controls != null || now - sentMicros >= RESEND_MICROS)) {
      in.send(out.newest().state().engineStarting() ? StartingEngine.safe(latest) : latest, now);
      sentMicros = now;
    }
  }

  /**
   * FlightGear accepts connections to a dead input channel and ignores their data. Only the echoed
   * count shows that FlightGear is listening.
   */
  private void listenForEcho(boolean flying, long now) {
    boolean heard = out.count() != heardCount;
    if (heard || !flying || latest == null) {
      if (heard && deaf) {
        deaf = false;
        troubles.event("FlightGear accepts controls again");
      }
      heardCount = out.count();
      heardMicros = now;
    } else if (now - heardMicros > DEAF_MICROS && !repair.isBusy()) {
      heardMicros = now;
      if (!deaf) {
        deaf = true;
        troubles.event("FlightGear does not accept controls");
      }
      in.drop();
      repair.in(now);
    }
  }

  private void callFlightGear(long now) {
    there = out.hasPeer() && (!out.everConnected() || now - out.lastLineMicros() < MUTE_MICROS);
    if (there) {
      peerMicros = now;
    } else if (now - peerMicros > (out.everConnected() ? GONE_MICROS : NEVER_CAME_MICROS)
        && !closing) {
      repair.out(out.port(), out.everConnected(), now, () -> !there);
    }
  }
}
