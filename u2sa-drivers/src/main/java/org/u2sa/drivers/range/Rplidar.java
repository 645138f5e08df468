package org.u2sa.drivers.range;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.interfaces.Clock;
import org.u2sa.messages.frame.Point;

/**
 * Runs an RPLIDAR: stops it, asks for its health, resets it if it has stopped to protect itself,
 * starts the standard scan, and begins again when scans fail to come.
 */
final class Rplidar implements Scanner {
  private static final byte[] STOP = {(byte) 0xA5, 0x25};
  private static final byte[] RESET = {(byte) 0xA5, 0x40};
  private static final byte[] SCAN = {(byte) 0xA5, 0x20};
  private static final byte[] GET_HEALTH = {(byte) 0xA5, 0x52};
  private static final int WARNING = 1;
  private static final int ERROR = 2;

  private static final long STOPPED_AFTER_MICROS = Clock.micros(0.05);
  private static final long RESET_AFTER_MICROS = Clock.micros(1.0);
  private static final long ANSWER_WITHIN_MICROS = Clock.micros(0.5);
  private static final long SPIN_UP_MICROS = Clock.micros(4.0);
  private static final long SCAN_WITHIN_MICROS = Clock.micros(1.0); // the slowest turns at 2 Hz

  private enum State {
    STOPPING,
    HEALTH_ASKED,
    RESETTING,
    SCAN_ASKED,
    SPINNING_UP,
    SCANNING
  }

  private final ByteLink link;
  private final RplidarParser parser = new RplidarParser();
  private final byte[] buffer = new byte[4096];
  private State state = State.STOPPING;
  private long untilMicros = Long.MIN_VALUE;
  private int connections;
  private Reading reading = NONE;
  private String trouble = "";
  private long unanswered;

  Rplidar(ByteLink link) {
    this.link = link;
  }

  @Override
  public Reading read(long nowMicros) {
    if (link.connections() != connections) {
      connections = link.connections();
      stop(nowMicros);
    }
    int count;
    while ((count = link.read(buffer)) > 0) {
      if (state != State.STOPPING && state != State.RESETTING) {
        parser.accept(buffer, count);
      }
    }
    advance(nowMicros);
    return reading;
  }

  private void advance(long nowMicros) {
    if (state == State.HEALTH_ASKED && parser.health().isPresent()) {
      judge(parser.health().get(), nowMicros);
    } else if (state == State.SCAN_ASKED && parser.isScanning()) {
      enter(State.SPINNING_UP, nowMicros + SPIN_UP_MICROS);
    }
    Optional<List<Point>> scan = parser.takeScan();
    if (scan.isPresent()) {
      reading = new Reading(nowMicros, scan.get());
      enter(State.SCANNING, nowMicros + SCAN_WITHIN_MICROS);
    }
    if (nowMicros >= untilMicros && link.isConnected()) {
      overdue(nowMicros);
    }
  }

  private void judge(RplidarParser.Health health, long nowMicros) {
    if (health.status() == ERROR) {
      trouble = "it has stopped to protect itself, error " + hex(health) + "; it is reset";
      ask(RESET, State.RESETTING, nowMicros + RESET_AFTER_MICROS);
      return;
    }
    if (health.status() == WARNING) {
      trouble = "warning " + hex(health);
    }
    ask(SCAN, State.SCAN_ASKED, nowMicros + ANSWER_WITHIN_MICROS);
  }

  private static String hex(RplidarParser.Health health) {
    return String.format(Locale.ROOT, "0x%04X", health.errorCode());
  }

  private void overdue(long nowMicros) {
    if (state == State.STOPPING) {
      ask(GET_HEALTH, State.HEALTH_ASKED, nowMicros + ANSWER_WITHIN_MICROS);
    } else {
      unanswered += state == State.RESETTING ? 0 : 1;
      stop(nowMicros);
    }
  }

  private void stop(long nowMicros) {
    ask(STOP, State.STOPPING, nowMicros + STOPPED_AFTER_MICROS);
  }

  private void ask(byte[] request, State next, long until) {
    parser.beginAnew();
    link.write(request); // one that is not taken is overdue later
    enter(next, until);
  }

  private void enter(State next, long until) {
    state = next;
    untilMicros = until;
  }

  @Override
  public long malformed() {
    return parser.malformed() + unanswered;
  }

  @Override
  public String trouble() {
    String said = trouble;
    trouble = "";
    return said;
  }

  @Override
  public void close() {
    try {
      link.write(STOP);
    } finally {
      link.close();
    }
  }
}
