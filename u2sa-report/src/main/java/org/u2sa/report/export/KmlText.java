package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.u2sa.report.EscapedXml;

/** Formats KML 2.2 with Google's timestamped tracks, cut at the antimeridian; goals as points. */
public final class KmlText {
  static final String ON_THE_GROUND = "clampToGround";
  static final String AT_ALTITUDE = "absolute";

  private KmlText() {}

  public static void write(Writer out, String title, GeoRun run) throws IOException {
    begin(
        out,
        title,
        "<Style id=\"track\"><LineStyle><color>ffb27200</color><width>3</width></LineStyle></Style>");
    for (Map.Entry<String, List<GeoRun.Fix>> track : run.tracks().entrySet()) {
      write(out, track.getKey(), track.getValue());
    }
    for (GeoRun.Goal goal : run.goals()) {
      point(
          out,
          goal.name(),
          String.format(
              Locale.ROOT,
              "%s, within %.1f m",
              goal.isReached() ? "reached" : "not reached",
              goal.thresholdM()),
          goal.longitudeDeg(),
          goal.latitudeDeg(),
          goal.altitudeM());
    }
    end(out);
  }

  private static void write(Writer out, String name, List<GeoRun.Fix> track) throws IOException {
    boolean isHigh = track.stream().allMatch(fix -> fix.altitudeM().isPresent());
    List<List<GeoRun.Fix>> parts = TrackParts.of(track);
    boolean isCut = parts.size() > 1;
    out.write(
        """
          <Placemark>
            <name>%s</name>
            <styleUrl>#track</styleUrl>
        """
            .formatted(EscapedXml.of(name)));
    out.write(isCut ? "    <gx:MultiTrack>\n" : "");
    for (List<GeoRun.Fix> part : parts) {
      write(out, part, isHigh ? AT_ALTITUDE : ON_THE_GROUND);
    }
    out.write(isCut ? "    </gx:MultiTrack>\n" : "");
    out.write("  </Placemark>\n");
  }

  private static void write(Writer out, List<GeoRun.Fix> part, String altitudeMode)
      throws IOException {
    out.write("    <gx:Track>\n      <altitudeMode>" + altitudeMode + "</altitudeMode>\n");
    for (GeoRun.Fix fix : part) {
      out.write("      <when>" + fix.time() + "</when>\n");
    }
    for (GeoRun.Fix fix : part) {
      out.write(
          String.format(
              Locale.ROOT,
              "      <gx:coord>%.9f %.9f %.3f</gx:coord>\n",
              fix.longitudeDeg(),
              fix.latitudeDeg(),
              fix.altitudeM().orElse(0.0)));
    }
    out.write("    </gx:Track>\n");
  }

  /** Writes everything before the first place; KML's colours are alpha, blue, green, red. */
  static void begin(Writer out, String title, String styles) throws IOException {
    out.write(
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <kml xmlns="http://www.opengis.net/kml/2.2" xmlns:gx="http://www.google.com/kml/ext/2.2">
        <Document>
          <name>%s</name>
        %s"""
            .formatted(EscapedXml.of(title), styles.indent(2)));
  }

  /** Writes a point; altitude above mean sea level [m], empty: on the ground. */
  static void point(
      Writer out,
      String name,
      String description,
      double longitudeDeg,
      double latitudeDeg,
      OptionalDouble altitudeM)
      throws IOException {
    out.write(
        String.format(
            Locale.ROOT,
            "  <Placemark><name>%s</name><description>%s</description><Point>"
                + "<altitudeMode>%s</altitudeMode><coordinates>%.9f,%.9f,%.3f</coordinates></Point></Placemark>\n",
            EscapedXml.of(name),
            description,
            altitudeM.isPresent() ? AT_ALTITUDE : ON_THE_GROUND,
            longitudeDeg,
            latitudeDeg,
            altitudeM.orElse(0.0)));
  }

  static void end(Writer out) throws IOException {
    out.write("</Document>\n</kml>\n");
  }
}
