package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.interfaces.Clock;
import org.u2sa.messages.frame.Point;

/**
 * Runs a Hokuyo, or another sensor that speaks SCIP 2: ends what it was doing, asks what it is,
 * switches the laser on, has it measure without end, and begins again when scans fail to come.
 */
final class Hokuyo implements Scanner {
  private static final String MEASURES = "99";
  private static final String DONE = "00";
  private static final String ALREADY = "02"; // in answer to "BM": the laser is on
  private static final long ANSWER_WITHIN_MICROS = Clock.micros(0.5);
  private static final long SCAN_WITHIN_MICROS = Clock.micros(1.0);

  private enum State {
    QUITTING("QT"),
    ASKING("PP"),
    LIGHTING("BM"),
    MEASURING("MD");

    private final String command;

    State(String command) {
      this.command = command;
    }
  }

  private final ByteLink link;
  private final ScipReader reader = new ScipReader();
  private final byte[] buffer = new byte[4096];
  private State state = State.QUITTING;
  private String asked = "";
  private ScipParameters sensor;
  private long untilMicros = Long.MIN_VALUE;
  private int connections;
  private Reading reading = NONE;
  private String trouble = "";
  private long malformed;

  Hokuyo(ByteLink link) {
    this.link = link;
  }

  @Override
  public Reading read(long nowMicros) {
    if (link.connections() != connections) {
      connections = link.connections();
      reader.beginAnew();
      ask(State.QUITTING, "QT", nowMicros);
    }
    int count;
    while ((count = link.read(buffer)) > 0) {
      reader.accept(buffer, count);
      Optional<List<String>> answer;
      while ((answer = reader.take()).isPresent()) {
        answered(answer.get(), nowMicros);
      }
    }
    if (nowMicros >= untilMicros && link.isConnected()) {
      malformed++;
      ask(State.QUITTING, "QT", nowMicros);
    }
    return reading;
  }

  private void answered(List<String> lines, long nowMicros) {
    if (!lines.get(0).startsWith(state.command)) {
      return; // a scan from before, or noise
    }
    if (lines.size() < 2 || lines.get(1).length() != 3 || !Scip.isChecked(lines.get(1))) {
      malformed++;
      return;
    }
    String status = lines.get(1).substring(0, 2);
    List<String> data = lines.subList(2, lines.size());
    switch (state) {
      case QUITTING:
        ask(State.ASKING, "PP", nowMicros);
        break;
      case ASKING:
        parameters(data, nowMicros);
        break;
      case LIGHTING:
        if (expect(status.equals(DONE) || status.equals(ALREADY), status)) {
          measure(nowMicros);
        }
        break;
      default:
        if (status.equals(MEASURES)) {
          scanned(data, nowMicros);
        } else {
          expect(status.equals(DONE), status);
        }
    }
  }

  /** What is not expected is said; the next request then is overdue, and all begins again. */
  private boolean expect(boolean isExpected, String status) {
    if (!isExpected) {
      trouble = "status " + status + " in answer to " + asked;
    }
    return isExpected;
  }

  private void parameters(List<String> data, long nowMicros) {
    Optional<ScipParameters> said = ScipParameters.of(data);
    if (said.isEmpty()) {
      malformed++;
      return;
    }
    sensor = said.get();
    ask(State.LIGHTING, "BM", nowMicros);
  }

  private void measure(long nowMicros) {
    String command = // each step by itself, each scan, without end
        String.format(Locale.ROOT, "MD%04d%04d01000", sensor.firstStep(), sensor.lastStep());
    ask(State.MEASURING, command, nowMicros);
    untilMicros = nowMicros + SCAN_WITHIN_MICROS;
  }

  private void scanned(List<String> data, long nowMicros) {
    Optional<List<Point>> points = ScipScan.points(data, sensor);
    if (points.isEmpty()) {
      malformed++;
      return;
    }
    reading = new Reading(nowMicros, points.get());
    untilMicros = nowMicros + SCAN_WITHIN_MICROS;
  }

  private void ask(State next, String command, long nowMicros) {
    state = next;
    asked = command;
    untilMicros = nowMicros + ANSWER_WITHIN_MICROS;
    link.write((command + "\n").getBytes(US_ASCII)); // one that is not taken is overdue later
  }

  @Override
  public long malformed() {
    return malformed + reader.malformed();
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
      link.write("QT\n".getBytes(US_ASCII));
    } finally {
      link.close();
    }
  }
}
