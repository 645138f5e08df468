package org.u2sa.report.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Geodetic;

/** Ground-truth track of a simulated vehicle: a demo's track.csv. */
final class TruthTrack {
  private static final List<String> COLUMNS =
      List.of("time_s", "longitude_deg", "latitude_deg", "altitude_m", "heading_deg");
  private static final double TURN_DEG = 360.0;

  /** Position and heading [rad, clockwise from north]. */
  record Place(Geodetic at, double headingRad) {}

  private final List<double[]> rows = new ArrayList<>(); // in COLUMNS' order, by time

  private TruthTrack() {}

  /**
   * Reads a file.
   *
   * @throws BadInputException if it is not a track.csv
   */
  static TruthTrack read(Path file) throws IOException {
    List<String> lines = Files.readAllLines(file);
    List<String> heads = lines.isEmpty() ? List.of() : Arrays.asList(lines.get(0).split(","));
    if (!heads.containsAll(COLUMNS)) {
      throw new BadInputException(
          file + ": expected a demo's track.csv with the columns " + String.join(", ", COLUMNS));
    }
    int[] at = COLUMNS.stream().mapToInt(heads::indexOf).toArray();
    TruthTrack track = new TruthTrack();
    for (int i = 1; i < lines.size(); i++) {
      String[] cells = lines.get(i).split(",");
      double[] row = new double[at.length];
      try {
        for (int c = 0; c < at.length; c++) {
          row[c] = Double.parseDouble(cells[at[c]]);
        }
      } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
        throw new BadInputException(file + ", line " + (i + 1) + ": expected numbers", e);
      }
      track.rows.add(row);
    }
    return track;
  }

  /** All samples, with times [s]. */
  List<double[]> rows() {
    return rows;
  }

  /** Interpolated position at a time [s]; empty outside the recorded interval. */
  Optional<Place> at(double timeS) {
    int low = 0;
    int high = rows.size() - 1;
    if (high < 0 || timeS < rows.get(0)[0] || timeS > rows.get(high)[0]) {
      return Optional.empty();
    }
    while (high - low > 1) {
      int middle = (low + high) / 2;
      if (rows.get(middle)[0] <= timeS) {
        low = middle;
      } else {
        high = middle;
      }
    }
    double[] a = rows.get(low);
    double[] b = rows.get(high);
    double share = b[0] > a[0] ? (timeS - a[0]) / (b[0] - a[0]) : 0.0;
    double turn = Math.IEEEremainder(b[4] - a[4], TURN_DEG);
    return Optional.of(
        new Place(
            new Geodetic(
                a[1] + share * Math.IEEEremainder(b[1] - a[1], TURN_DEG), // Geodetic wraps it
                a[2] + share * (b[2] - a[2]),
                a[3] + share * (b[3] - a[3])),
            Math.toRadians(a[4] + share * turn)));
  }
}
