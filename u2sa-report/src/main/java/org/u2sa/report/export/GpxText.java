package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.report.EscapedXml;

/**
 * Formats GPX 1.1 (topografix.com/GPX/1/1): tracks with times, goals as waypoints. Longitudes are
 * in -180 (inclusive) to 180 (exclusive) degrees.
 */
public final class GpxText {
  private static final double HALF_TURN_DEG = 180.0;
  private static final double DEGREE_STEPS = 1e9; // resolution of the output

  private GpxText() {}

  public static void write(Writer out, String title, GeoRun run) throws IOException {
    out.write(
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <gpx version="1.1" creator="u2sa" xmlns="http://www.topografix.com/GPX/1/1">
          <metadata><name>%s</name></metadata>
        """
            .formatted(EscapedXml.of(title)));
    for (GeoRun.Goal goal : run.goals()) {
      place(out, "  <wpt", goal.longitudeDeg(), goal.latitudeDeg(), goal.altitudeM());
      out.write(
          "<name>%s</name><desc>%s</desc></wpt>\n"
              .formatted(EscapedXml.of(goal.name()), goal.isReached() ? "reached" : "not reached"));
    }
    for (Map.Entry<String, List<GeoRun.Fix>> track : run.tracks().entrySet()) {
      out.write(
          "  <trk>\n    <name>%s</name>\n    <trkseg>\n".formatted(EscapedXml.of(track.getKey())));
      double before = Double.NaN;
      for (GeoRun.Fix fix : track.getValue()) {
        double longitude = below180(fix.longitudeDeg());
        if (Math.abs(longitude - before)
            > HALF_TURN_DEG) { // viewers would draw a line round the world
          out.write("    </trkseg>\n    <trkseg>\n");
        }
        before = longitude;
        place(out, "      <trkpt", fix.longitudeDeg(), fix.latitudeDeg(), fix.altitudeM());
        out.write("<time>" + fix.time() + "</time></trkpt>\n");
      }
      out.write("    </trkseg>\n  </trk>\n");
    }
    out.write("</gpx>\n");
  }

  private static void place(
      Writer out, String tag, double longitude, double latitude, OptionalDouble altitude)
      throws IOException {
    String text = "%s lat=\"%.9f\" lon=\"%.9f\">";
    out.write(String.format(Locale.ROOT, text, tag, latitude, below180(longitude)));
    if (altitude.isPresent()) {
      out.write(String.format(Locale.ROOT, "<ele>%.3f</ele>", altitude.getAsDouble()));
    }
  }

  private static double below180(double longitude) {
    double rounded = Math.rint(longitude * DEGREE_STEPS) / DEGREE_STEPS;
    return rounded >= HALF_TURN_DEG ? rounded - 2.0 * HALF_TURN_DEG : rounded;
  }
}
