package org.u2sa.drivers.range;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/** Reads the data of "MD" and "GD" answers: a time stamp, then distances of three characters. */
final class ScipScan {
  private static final int CHARACTERS = 3;
  private static final double MILLI = 0.001;

  private ScipScan() {}

  /**
   * The points that were seen, in the sensor's axes.
   *
   * @param lines after the status: time stamp, and blocks of at most 64 characters, each with its
   *     check character
   * @return empty if a check character is wrong, or the number of distances is not the sensor's
   */
  static Optional<List<Point>> points(List<String> lines, ScipParameters sensor) {
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
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < sensor.steps(); i++) {
      int mm = Scip.decode(data, i * CHARACTERS, CHARACTERS);
      if (mm < 0) {
        return Optional.empty();
      }
      if (mm >= sensor.nearestMm() && mm <= sensor.farthestMm()) { // below are error codes
        points.add(Point.polar(sensor.azimuth(sensor.firstStep() + i), 0.0, mm * MILLI));
      }
    }
    return Optional.of(points);
  }
}
