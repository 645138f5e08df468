package org.u2sa.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Detects sensors that should be measuring but are silent. A silent camera may simply see nothing,
 * but a scanner publishes scans or point clouds even over empty ground.
 */
final class AwaitedSensors {
  /** Placeholder for a scanner that has never scanned, whose name is therefore unknown. */
  static final String ANY_SCANNER = "any scanner";

  private static final double MISSED = 2.0; // intervals after which a slow scanner is silent
  private static final long LONGEST_MICROS = 5_000_000; // maximum interval taken into account

  /**
   * Timing of a scanner's messages.
   *
   * @param newest end of its newest scan [µs]
   * @param interval since the previous message [µs]
   * @param usual the shorter of the last two intervals, so that a single gap does not count [µs]
   */
  private record Scans(long newest, long interval, long usual) {
    Scans then(long micros) {
      long now = Math.min(LONGEST_MICROS, micros - newest);
      return now > 0 ? new Scans(micros, now, Math.min(now, interval)) : this;
    }
  }

  private final int needed; // measurements of a sensor before it counts
  private final Map<String, Integer> counts = new TreeMap<>(); // of each sensor's measurements
  private final Map<String, Scans> scanned = new TreeMap<>(); // by scanner, of either kind
  private final Set<String> cloudy = new TreeSet<>(); // scanners that publish clouds
  private final Map<String, Long> seen = new TreeMap<>(); // newest sighting of each sensor [µs]

  /**
   * @param needed measurements of a sensor before it counts: after a restart, objects that it saw
   *     must be confirmed again before the vehicle may rely on the map
   */
  AwaitedSensors(int needed) {
    this.needed = needed;
  }

  /** Registers a scan that was placed on the map and ended at a time. */
  void scan(String sensor, long micros) {
    counts.merge(sensor, 1, Integer::sum);
    Scans before = scanned.get(sensor);
    scanned.put(sensor, before == null ? new Scans(micros, 0, 0) : before.then(micros));
  }

  /** Registers a cloud that is a scan and was placed on the map. */
  void cloud(String sensor, long micros) {
    if (!scanned.containsKey(sensor)) {
      cloudy.add(sensor);
    }
    scan(sensor, micros);
  }

  /** Registers a sighting that was placed on the map. */
  void sighting(String sensor, long micros) {
    counts.merge(sensor, 1, Integer::sum);
    seen.merge(sensor, micros, Math::max);
  }

  /** Scanners known so far that do not publish clouds. */
  List<String> scanners() {
    List<String> names = new ArrayList<>(scanned.keySet());
    names.removeAll(cloudy);
    return names;
  }

  List<String> cloudScanners() {
    return List.copyOf(cloudy);
  }

  /**
   * Sensors that should be measuring and are silent.
   *
   * @param expected names of the sensors to expect; empty: every scanner known so far
   * @param needsScans whether at least one scan, not a cloud, is required if no expected sensors
   *     are named
   * @param nowMicros time of the map [µs]
   * @param silentMicros age from which a measurement is too old; without expected names, a slower
   *     scanner may take twice its usual interval [µs]
   */
  List<String> silent(
      List<String> expected, boolean needsScans, long nowMicros, long silentMicros) {
    long since = nowMicros - silentMicros;
    List<String> silent = new ArrayList<>(expected.isEmpty() ? scanned.keySet() : expected);
    silent.removeIf(
        sensor ->
            counts.getOrDefault(sensor, 0) >= needed
                && (scansSince(sensor, nowMicros, since, expected.isEmpty())
                    || seen.getOrDefault(sensor, Long.MIN_VALUE) >= since));
    if (expected.isEmpty() && needsScans && scanners().isEmpty()) {
      silent.add(ANY_SCANNER);
    }
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
