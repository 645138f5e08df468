package org.u2sa.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Monitors which expected sensors are silent. The absence of sightings proves nothing, since there
 * may be nothing to see, but a scanner also reports scans of empty ground.
 */
final class AwaitedSensors {
  /** Placeholder for a scanner whose name is unknown because it never scanned. */
  static final String ANY_SCANNER = "any scanner";

  private static final double MISSED = 2.0; // intervals after which a slow scanner is silent
  private static final long LONGEST_MICROS = 5_000_000; // interval that is allowed for

  /**
   * State of a scanner.
   *
   * @param newest end of its newest scan [µs]
   * @param interval interval to the previous scan [µs]
   * @param usual the shorter one of the last two intervals: a gap is no habit [µs]
   */
  private record Scans(long newest, long interval, long usual) {
    Scans then(long micros) {
      long now = Math.min(LONGEST_MICROS, micros - newest);
      return now > 0 ? new Scans(micros, now, Math.min(now, interval)) : this;
    }
  }

  private final Map<String, Scans> scanned = new TreeMap<>(); // by scanner
  private final Map<String, Long> seen = new TreeMap<>(); // newest sighting of each sensor [us]

  /** Registers a scan that was placed on the map and ended at a time. */
  void scan(String sensor, long micros) {
    Scans before = scanned.get(sensor);
    scanned.put(sensor, before == null ? new Scans(micros, 0, 0) : before.then(micros));
  }

  /** Registers a sighting that was placed on the map. */
  void sighting(String sensor, long micros) {
    seen.merge(sensor, micros, Math::max);
  }

  List<String> scanners() {
    return List.copyOf(scanned.keySet());
  }

  /**
   * Sensors that should be measuring and are silent.
   *
   * @param expected names of the expected sensors; if empty, each scanner heard so far
   * @param needsScans whether at least one scan is needed if no sensor is named
   * @param nowMicros time of the map [µs]
   * @param silentMicros age from which a measurement is too old; without expected names, a slower
   *     scanner may take twice its usual interval [µs]
   */
  List<String> silent(
      List<String> expected, boolean needsScans, long nowMicros, long silentMicros) {
    long since = nowMicros - silentMicros;
    if (expected.isEmpty() && scanned.isEmpty()) {
      return needsScans ? List.of(ANY_SCANNER) : List.of();
    }
    List<String> silent = new ArrayList<>(expected.isEmpty() ? scanned.keySet() : expected);
    silent.removeIf(sensor -> scansSince(sensor, nowMicros, since, expected.isEmpty()));
    silent.removeIf(sensor -> seen.getOrDefault(sensor, Long.MIN_VALUE) >= since);
    return silent;
  }

  private boolean scansSince(String sensor, long nowMicros, long since, boolean asUsual) {
    Scans scans = scanned.get(sensor);
    if (scans == null) {
      return false;
    }
    long patience = asUsual ? Math.round(MISSED * scans.usual()) : 0;
    return scans.newest() >= Math.min(since, nowMicros - patience);
  }
}
