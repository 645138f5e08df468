package org.u2sa.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Which sensors should be measuring and are not. A sighting says nothing about the next one, since
 * there may be nothing to see; a scanner, however, scans empty ground too.
 */
final class AwaitedSensors {
  /** Stands for a scanner whose name is not known because it never scanned. */
  static final String ANY_SCANNER = "any scanner";

  private final Map<String, Long> scanned = new TreeMap<>(); // newest scan of each scanner [us]
  private final Map<String, Long> seen = new TreeMap<>(); // newest sighting of each sensor [us]

  /** Registers a scan that was placed on the map. */
  void scan(String sensor, long micros) {
    scanned.merge(sensor, micros, Math::max);
  }

  /** Registers a sighting that was placed on the map. */
  void sighting(String sensor, long micros) {
    seen.merge(sensor, micros, Math::max);
  }

  /** Scanners heard so far. */
  List<String> scanners() {
    return List.copyOf(scanned.keySet());
  }

  /**
   * Sensors that should be measuring and are silent.
   *
   * @param expected names of the sensors that should; if empty, each scanner that was ever heard
   * @param needsScans whether at least one scan is needed if nothing is named as expected
   * @param since measurement time before which a measurement is too old [us]
   */
  List<String> silent(List<String> expected, boolean needsScans, long since) {
    if (expected.isEmpty() && scanned.isEmpty()) {
      return needsScans ? List.of(ANY_SCANNER) : List.of();
    }
    List<String> silent = new ArrayList<>(expected.isEmpty() ? scanned.keySet() : expected);
    silent.removeIf(sensor -> isSince(scanned.get(sensor), since));
    silent.removeIf(sensor -> isSince(seen.get(sensor), since));
    return silent;
  }

  private static boolean isSince(Long micros, long since) {
    return micros != null && micros >= since;
  }
}
