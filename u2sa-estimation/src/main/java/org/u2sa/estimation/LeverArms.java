package org.u2sa.estimation;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.SensorParts;

/**
 * Mounting positions of sensors on the vehicle, by sensor name, parsed from a configuration text.
 */
final class LeverArms {
  private static final String FORM = "expected \"SENSOR = FORWARD LEFT DOWN; …\" in metres";
  private static final double FARTHEST_M = 100.0;

  private final Map<String, double[]> arms = new TreeMap<>(); // forward, left, down [m]

  /**
   * @param text "IoioService GPS = 0.4 0 -0.6; WaterSpeedSensor = -0.2 0 0.1"; empty: none
   * @throws IllegalArgumentException naming the invalid part
   */
  LeverArms(String text) {
    for (String part : text.split(";")) {
      if (!part.trim().isEmpty()) {
        read(part.trim());
      }
    }
  }

  private void read(String part) {
    int equals = part.indexOf('=');
    String sensor = part.substring(0, Math.max(0, equals)).trim();
    String[] numbers = part.substring(equals + 1).trim().split("\\s+");
    if (sensor.isEmpty() || numbers.length != 3) {
      throw new IllegalArgumentException("\"" + part + "\": " + FORM);
    }
    double[] arm = new double[3];
    for (int i = 0; i < 3; i++) {
      arm[i] = metres(part, numbers[i]);
    }
    if (arms.put(sensor, arm) != null) {
      throw new IllegalArgumentException("\"" + part + "\": " + sensor + " appears twice");
    }
  }

  private static double metres(String part, String number) {
    double metres;
    try {
      metres = Double.parseDouble(number);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "\"" + part + "\": \"" + number + "\" is not a number; " + FORM, e);
    }
    if (!(Math.abs(metres) <= FARTHEST_M)) {
      throw new IllegalArgumentException(
          "\"" + part + "\": " + number + " m is outside -" + FARTHEST_M + "…" + FARTHEST_M);
    }
    return metres;
  }

  /** Names of the sensors. */
  Set<String> sensors() {
    return arms.keySet();
  }

  /** Mounting position of a sensor or of one of its parts: forward, left, down [m]. */
  Optional<double[]> of(String sensor) {
    return Optional.ofNullable(arms.get(sensor))
        .or(
            () ->
                arms.entrySet().stream()
                    .filter(each -> SensorParts.sensor(each.getKey()).equals(sensor))
                    .map(Map.Entry::getValue)
                    .findFirst());
  }

  /** Adds the sensor's mounting position to a measurement. */
  Measurement place(Measurement m) {
    return SensorParts.value(arms, m.source())
        .map(arm -> m.mounted(arm[0], -arm[1], arm[2])) // the filter's y points right
        .orElse(m);
  }
}
