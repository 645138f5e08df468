package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/** Reads the data of "MD" and "GD" answers: a time stamp, then distances of three characters. */
final class ScipScan {
  private static final int CHARACTERS = 3;
  static final double MILLI = 0.001;

  private ScipScan() {}

  /**
   * What each step measured [m]; empty where no echo came: less than the nearest is an error code,
   * more than the farthest nothing.
   *
   * @param lines after the status: time stamp, and blocks of at most 64 characters, each with its
   *     check character
   * @return empty if a check character is wrong, or the number of distances is not the sensor's
   */
  static Optional<List<OptionalDouble>> ranges(List<String> lines, ScipParameters sensor) {
    StringBuilder data = new StringBuilder();
    for (int i = 0; i < lines.size(); i++) {
      if (!Scip.isChecked(lines.get(i))) {
        return Optional.empty();
      }
      if (i > 0) { // the first is the time stamp
        data.append(lines.get(i), 0, lines.get(i).length() - 1);
      }
    }
    if (data.length() != sensor.steps() * CHARACTERS) {
      return Optional.empty();
    }
    List<OptionalDouble> ranges = new ArrayList<>(sensor.steps());
    for (int i = 0; i < sensor.steps(); i++) {
      int mm = Scip.decode(data, i * CHARACTERS, CHARACTERS);
      if (mm < 0) {
        return Optional.empty();
      }
      boolean isEcho = mm >= sensor.nearestMm() && mm <= sensor.farthestMm();
      ranges.add(isEcho ? OptionalDouble.of(mm * MILLI) : OptionalDouble.empty());
    }
    return Optional.of(ranges);
  }
}
