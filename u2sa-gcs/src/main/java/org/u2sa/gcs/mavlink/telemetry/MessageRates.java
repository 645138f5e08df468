package org.u2sa.gcs.mavlink.telemetry;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.gcs.mavlink.station.GroundStation;

/** Rates of the messages to one station. */
public final class MessageRates {
  private static final double MAX_HZ = 50.0;
  private static final long MICROS_PER_S = 1_000_000;
  private static final double MAX_MICROS = Integer.MAX_VALUE; // maximum of MESSAGE_INTERVAL
  private static final long OFF = -1;
  private static final int ALL_STREAMS = 0;

  /** MAV_DATA_STREAM, which stations of ArduPilot request. */
  private static final Map<Integer, List<Integer>> STREAMS =
      Map.of(
          2, List.of(1, 2, 24, 62, Telemetry.MISSION_CURRENT, 147), // EXTENDED_STATUS
          6, List.of(32, 33), // POSITION
          3, List.of(36), // RC_CHANNELS
          10, List.of(30), // EXTRA1
          11, List.of(74), // EXTRA2
          12, List.of(230, 147, 231, 246, 330)); // EXTRA3

  private final Telemetry telemetry;
  private final Map<Integer, Long> intervals = new TreeMap<>(); // [µs]; OFF: none
  private final Map<Integer, Long> due = new TreeMap<>();

  /** Starts with the usual rates. */
  public MessageRates(Telemetry telemetry) {
    this.telemetry = telemetry;
    telemetry.sources().forEach((id, source) -> intervals.put(id, interval(source.usualHz())));
  }

  private static long interval(double hz) {
    return hz > 0.0 ? Math.round(MICROS_PER_S / Math.min(MAX_HZ, hz)) : OFF;
  }

  /** Sends due messages: the heartbeat, then those waiting longest, while there is room. */
  public void step(long nowMicros, GroundStation to) {
    List<Integer> waiting = new ArrayList<>();
    intervals.forEach(
        (id, interval) -> {
          if (interval != OFF && nowMicros >= dueMicros(id)) {
            waiting.add(id);
          }
        });
    waiting.sort(Comparator.comparing(this::dueMicros));
    for (int id : waiting) {
      if (id == Telemetry.HEARTBEAT || to.hasRoom()) {
        long interval = intervals.get(id);
        long late = nowMicros - due.getOrDefault(id, nowMicros);
        due.put(id, nowMicros + interval - Math.min(late, interval / 2));
        telemetry.sources().get(id).make().get().ifPresent(to::send);
      }
    }
  }

  private long dueMicros(int id) {
    return due.getOrDefault(id, Long.MIN_VALUE);
  }

  /**
   * Sets an interval.
   *
   * @param micros interval [µs]; 0: the usual one; negative: off
   * @return false if there is no such message
   */
  public boolean set(int id, double micros) {
    Telemetry.Source source = telemetry.sources().get(id);
    if (source == null || Double.isNaN(micros)) {
      return false;
    }
    if (id != Telemetry.HEARTBEAT) { // without heartbeats the vehicle counts as lost
      intervals.put(
          id,
          micros == 0.0
              ? interval(source.usualHz())
              : micros < 0.0
                  ? OFF
                  : Math.round(Math.min(MAX_MICROS, Math.max(MICROS_PER_S / MAX_HZ, micros))));
      due.remove(id);
    }
    return true;
  }

  /** Interval of a message [µs]: −1 if it is off, 0 if the message does not exist. */
  public int get(int id) {
    return intervals.getOrDefault(id, 0L).intValue();
  }

  public void stream(int stream, int hz, boolean on) {
    STREAMS.forEach(
        (id, messages) -> {
          if (stream == ALL_STREAMS || stream == id) {
            messages.forEach(each -> set(each, on && hz > 0 ? (double) MICROS_PER_S / hz : OFF));
          }
        });
  }
}
