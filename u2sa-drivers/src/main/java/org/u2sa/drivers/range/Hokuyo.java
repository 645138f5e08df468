package org.u2sa.drivers.range;

import static java.nio.charset.StandardCharsets.US_ASCII;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.device.port.LaserScanner;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.LinkedDevice;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.RangeScan;

/**
 * Operates a Hokuyo or another SCIP 2 sensor: selects SCIP 2, stops any measurement, queries its
 * parameters, switches the laser on, starts continuous measurement, and restarts when scans stop
 * arriving.
 *
 * <p>A URG-04LX powers up in SCIP 1.1 and answers "SCIP2.0" with status 0; one already in SCIP 2
 * rejects it ("0E") or stays silent. Both are accepted.
 */
public final class Hokuyo extends LinkedDevice<LaserScanner.Scan> implements LaserScanner {
  private static final String MEASURES = "99";
  private static final String DONE = "00";
  private static final String ALREADY = "02"; // reply to "BM": the laser is already on
  private static final long ANSWER_WITHIN_MICROS = Clock.micros(0.5);
  private static final long SCAN_WITHIN_MICROS = Clock.micros(1.0);

  private enum State {
    SWITCHING("SCIP2.0"),
    QUITTING("QT"),
    ASKING("PP"),
    LIGHTING("BM"),
    MEASURING("MD");

    private final String command;

    State(String command) {
      this.command = command;
    }
  }

  private final ScipReader reader = new ScipReader();
  private State state = State.SWITCHING;
  private String asked = "";
  private ScipSensor sensor;
  private long untilMicros = Long.MIN_VALUE;
  private String trouble = "";

  public Hokuyo(ByteLink link) {
    super(link);
  }

  @Override
  protected void found(long nowMicros) {
    reader.reset();
    begin(nowMicros);
  }

  @Override
  protected void hear(byte[] bytes, int length, long nowMicros) {
    reader.accept(bytes, length);
    Optional<List<String>> answer;
    while ((answer = reader.take()).isPresent()) {
      answered(answer.get(), nowMicros);
    }
  }

  @Override
  protected void act(long nowMicros) {
    if (nowMicros >= untilMicros && link.isConnected()) {
      overdue(nowMicros);
    }
  }

  private void begin(long nowMicros) {
    ask(State.SWITCHING, State.SWITCHING.command, nowMicros);
  }

  private void overdue(long nowMicros) {
    if (state == State.SWITCHING) {
      ask(State.QUITTING, "QT", nowMicros);
    } else {
      refuse("no answer to " + asked);
      begin(nowMicros);
    }
  }

  private void answered(List<String> lines, long nowMicros) {
    if (!lines.get(0).startsWith(state.command)) {
      return; // an earlier scan, or noise
    }
    if (state == State.SWITCHING) { // SCIP 1.1 has no checksums
      ask(State.QUITTING, "QT", nowMicros);
      return;
    }
    if (lines.size() < 2 || lines.get(1).length() != 3 || !ScipSensor.isChecked(lines.get(1))) {
      refuse("a status with a wrong checksum");
      return;
    }
    String status = lines.get(1).substring(0, 2);
    List<String> data = lines.subList(2, lines.size());
    switch (state) {
      case QUITTING -> ask(State.ASKING, "PP", nowMicros);
      case ASKING -> parameters(data, nowMicros);
      case LIGHTING -> {
        if (expect(status.equals(DONE) || status.equals(ALREADY), status)) {
          measure(nowMicros);
        }
      }
      default -> {
        if (status.equals(MEASURES)) {
          scanned(data, nowMicros);
        } else {
          expect(status.equals(DONE), status);
        }
      }
    }
  }

  /** Reports an unexpected reply; the next request then times out and the sequence restarts. */
  private boolean expect(boolean isExpected, String status) {
    if (!isExpected) {
      trouble = "the laser answered " + asked + " with status " + status;
    }
    return isExpected;
  }

  private void parameters(List<String> data, long nowMicros) {
    Optional<ScipSensor> said = ScipSensor.of(data);
    if (said.isEmpty()) {
      refuse("invalid parameters");
      return;
    }
    sensor = said.get();
    ask(State.LIGHTING, "BM", nowMicros);
  }

  private void measure(long nowMicros) {
    String command = // every step, every scan, continuously
        String.format(Locale.ROOT, "MD%04d%04d01000", sensor.firstStep(), sensor.lastStep());
    ask(State.MEASURING, command, nowMicros);
    untilMicros = nowMicros + SCAN_WITHIN_MICROS;
  }

  private void scanned(List<String> data, long nowMicros) {
    Optional<List<OptionalDouble>> ranges = sensor.ranges(data);
    if (ranges.isEmpty()) {
      refuse("a damaged scan");
      return;
    }
    RangeScan scan =
        new RangeScan()
            .minRange(sensor.nearestMm() * ScipSensor.MILLI)
            .maxRange(sensor.farthestMm() * ScipSensor.MILLI)
            .timeIncrement(sensor.stepS())
            .beams(sensor.azimuth(sensor.firstStep()), sensor.stepRad(), ranges.get());
    scan.timestamp(nowMicros - Clock.micros(sensor.steps() * sensor.stepS())); // sent when complete
    latest = Optional.of(new Scan(nowMicros, scan));
    trouble = "";
    untilMicros = nowMicros + SCAN_WITHIN_MICROS;
  }

  private void ask(State next, String command, long nowMicros) {
    state = next;
    asked = command;
    untilMicros = nowMicros + ANSWER_WITHIN_MICROS;
    link.write((command + "\n").getBytes(US_ASCII)); // an unsent request times out later
  }

  @Override
  public long malformed() {
    return super.malformed() + reader.malformed();
  }

  @Override
  protected String ownTrouble() {
    return trouble;
  }

  @Override
  public void close() {
    try {
      link.write("QT\n".getBytes(US_ASCII));
    } finally {
      link.close();
    }
  }

  /** Provider of LIDAR = hokuyo. */
  public static final class Provider extends LinkProvider<LaserScanner> {
    public Provider() {
      super(LaserScanner.class, Hokuyo::new, "hokuyo");
    }
  }
}
