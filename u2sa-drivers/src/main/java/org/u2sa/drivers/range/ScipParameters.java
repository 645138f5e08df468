package org.u2sa.drivers.range;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What a SCIP sensor says of itself in answer to "PP".
 *
 * @param nearestMm DMIN: less is an error code [mm]
 * @param farthestMm DMAX: more is nothing [mm]
 * @param stepsPerTurn ARES
 * @param firstStep AMIN
 * @param lastStep AMAX
 * @param frontStep AFRT: the step straight ahead
 * @param turnsPerMinute SCAN; 0 if it does not say
 */
record ScipParameters(
    int nearestMm,
    int farthestMm,
    int stepsPerTurn,
    int firstStep,
    int lastStep,
    int frontStep,
    int turnsPerMinute) {
  private static final int MOST_STEPS = 8192;
  private static final double SECONDS_PER_MINUTE = 60.0;

  /** Reads the lines after the status, each "NAME:value;sum"; empty if one is wrong or missing. */
  static Optional<ScipParameters> of(List<String> lines) {
    Map<String, Integer> values = new HashMap<>();
    for (String line : lines) {
      int colon = line.indexOf(':');
      int semicolon = line.lastIndexOf(';');
      if (colon < 0 || semicolon != line.length() - 2 || semicolon < colon) {
        return Optional.empty();
      }
      // The sum leaves out the semicolon, against the specification's figure but as sensors do.
      if (line.charAt(semicolon + 1) != Scip.sum(line.substring(0, semicolon))) {
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

  private static Optional<ScipParameters> of(Map<String, Integer> values) {
    if (!values.keySet().containsAll(List.of("DMIN", "DMAX", "ARES", "AMIN", "AMAX", "AFRT"))) {
      return Optional.empty();
    }
    ScipParameters parameters =
        new ScipParameters(
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
            && parameters.lastStep < MOST_STEPS;
    return fits ? Optional.of(parameters) : Optional.empty();
  }

  /** How many distances a scan has. */
  int steps() {
    return lastStep - firstStep + 1;
  }

  /** From each step to the next [rad]. */
  double stepRad() {
    return 2.0 * Math.PI / stepsPerTurn;
  }

  /** Time from each step to the next [s]; 0 if not known. */
  double stepS() {
    return turnsPerMinute == 0 ? 0.0 : SECONDS_PER_MINUTE / turnsPerMinute / stepsPerTurn;
  }

  /** Direction of a step from straight ahead, to the left positive [rad]; seen from above. */
  double azimuth(int step) {
    return (step - frontStep) * stepRad();
  }
}
