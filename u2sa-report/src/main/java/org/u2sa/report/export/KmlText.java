package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.u2sa.report.EscapedXml;

/** Formats KML 2.2 with Google's timestamped tracks, cut at the antimeridian; goals as points. */
public final class KmlText {
  private KmlText() {}

  public static void write(Writer out, String title, GeoRun run) throws IOException {
    KmlDocument.begin(
        out,
        title,
        "<Style id=\"track\"><LineStyle><color>ffb27200</color><width>3</width></LineStyle></Style>");
    for (Map.Entry<String, List<GeoRun.Fix>> track : run.tracks().entrySet()) {
      write(out, track.getKey(), track.getValue());
    }
    for (GeoRun.Goal goal : run.goals()) {
      KmlDocument.point(
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
    KmlDocument.end(out);
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
      write(out, part, isHigh ? KmlDocument.AT_ALTITUDE : KmlDocument.ON_THE_GROUND);
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
}
