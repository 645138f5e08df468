package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Parameters of a SCIP 2 sensor from its reply to "PP", and decoding of its data: checksum
 * characters and 6-bit encoded numbers (Hokuyo C-42-03320B, "Communication Protocol Specification
 * for SCIP2.0 Standard", chapters 6 and 7).
 *
 * @param nearestMm DMIN: smaller values are error codes [mm]
 * @param farthestMm DMAX: larger values mean no echo [mm]
 * @param stepsPerTurn ARES
 * @param firstStep AMIN
 * @param lastStep AMAX
 * @param frontStep AFRT: step pointing straight ahead
 * @param turnsPerMinute SCAN; 0 if unknown
 */
record ScipSensor(
    int nearestMm,
    int farthestMm,
    int stepsPerTurn,
    int firstStep,
    int lastStep,
    int frontStep,
    int turnsPerMinute) {
  private static final int MAX_STEPS = 8192;
  private static final double SECONDS_PER_MINUTE = 60.0;
  private static final int SIX_BITS = 0x3F;
  private static final int OFFSET = 0x30;
  private static final int CHARACTERS = 3; // per distance
  private static final int MAX_NO_ECHO = 1; // highest error code for no echo
  static final double MILLI = 0.001;

  /**
   * Parses the lines after the status, each "NAME:value;sum"; empty if one is invalid or missing.
   */
  static Optional<ScipSensor> of(List<String> lines) {
    Map<String, Integer> values = new HashMap<>();
    for (String line : lines) {
      int colon = line.indexOf(':');
      int semicolon = line.lastIndexOf(';');
      if (colon < 0 || semicolon != line.length() - 2 || semicolon < colon) {
        return Optional.empty();
      }
      // Contrary to the specification's figure, sensors exclude the semicolon from the sum.
      if (line.charAt(semicolon + 1) != sum(line.substring(0, semicolon))) {
        return Optional.empty();
      }
      parse(line.substring(colon + 1, semicolon).trim())
          .ifPresent(value -> values.put(line.substring(0, colon), value));
    }
    return of(values);
  }

  private static Optional<Integer> parse(String digits) {
    boolean isNumber = !digits.isEmpty() && digits.length() < 10;
    for (int i = 0; i < digits.length(); i++) {
      isNumber &= digits.charAt(i) >= '0' && digits.charAt(i) <= '9';
    }
    return isNumber ? Optional.of(Integer.parseInt(digits)) : Optional.empty();
  }

  private static Optional<ScipSensor> of(Map<String, Integer> values) {
    if (!values.keySet().containsAll(List.of("DMIN", "DMAX", "ARES", "AMIN", "AMAX", "AFRT"))) {
      return Optional.empty();
    }
    ScipSensor parameters =
        new ScipSensor(
            values.get("DMIN"),
            values.get("DMAX"),
            values.get("ARES"),
            values.get("AMIN"),
            values.get("AMAX"),
            values.get("AFRT"),
            values.getOrDefault("SCAN", 0));
    boolean fits =
        parameters.stepsPerTurn > 0
            && parameters.firstStep <= parameters.lastStep
            && parameters.lastStep < MAX_STEPS;
    return fits ? Optional.of(parameters) : Optional.empty();
  }

  /** Number of distances per scan. */
  int steps() {
    return lastStep - firstStep + 1;
  }

  /** Angle between steps [rad]. */
  double stepRad() {
    return 2.0 * Math.PI / stepsPerTurn;
  }

  /** Time between steps [s]; 0 if unknown. */
  double stepS() {
    return turnsPerMinute == 0 ? 0.0 : SECONDS_PER_MINUTE / turnsPerMinute / stepsPerTurn;
  }

  /** Direction of a step relative to straight ahead, left positive seen from above [rad]. */
  double azimuth(int step) {
    return (step - frontStep) * stepRad();
  }

  /**
   * Ranges per step [m]; empty without an echo: above the maximum, or an error code for nothing in
   * range or too little light (0 and 1 in tables 3 and 4). Other codes, such as for an object too
   * close or a dazzling reflection, are ambiguous: they remain ranges below the minimum, which
   * indicate neither an obstacle nor free space.
   *
   * @param lines lines after the status: timestamp, and blocks of up to 64 characters with a
   *     checksum character each
   * @return empty if a checksum is wrong or the number of distances differs from the steps
   */
  Optional<List<OptionalDouble>> ranges(List<String> lines) {
    StringBuilder data = new StringBuilder();
    for (int i = 0; i < lines.size(); i++) {
      if (!isChecked(lines.get(i))) {
        return Optional.empty();
      }
      if (i > 0) { // line 0 is the timestamp
        data.append(lines.get(i), 0, lines.get(i).length() - 1);
      }
    }
    if (data.length() != steps() * CHARACTERS) {
      return Optional.empty();
    }
    List<OptionalDouble> ranges = new ArrayList<>(steps());
    for (int i = 0; i < steps(); i++) {
      int mm = decode(data, i * CHARACTERS, CHARACTERS);
      if (mm < 0) {
        return Optional.empty();
      }
      boolean isNothing = mm <= MAX_NO_ECHO || mm > farthestMm;
      ranges.add(isNothing ? OptionalDouble.empty() : OptionalDouble.of(mm * MILLI));
    }
    return Optional.of(ranges);
  }

  /** Checksum character of a text: the low six bits of the sum, as a printable character. */
  static char sum(CharSequence text) {
    int sum = 0;
    for (int i = 0; i < text.length(); i++) {
      sum += text.charAt(i);
    }
    return (char) ((sum & SIX_BITS) + OFFSET);
  }

  /** Whether a line ends with a valid checksum character. */
  static boolean isChecked(CharSequence line) {
    int end = line.length() - 1;
    return end >= 0 && line.charAt(end) == sum(line.subSequence(0, end));
  }

  /** Decodes characters of six bits each; −1 if one is invalid. */
  static int decode(CharSequence text, int from, int characters) {
    int value = 0;
    for (int i = from; i < from + characters; i++) {
      int six = text.charAt(i) - OFFSET;
      if (six < 0 || six > SIX_BITS) {
        return -1;
      }
      value = value << 6 | six;
    }
    return value;
  }
}
