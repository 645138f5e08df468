package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.report.score.Domain;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.RunScore;
import org.u2sa.report.score.TrackSample;
import org.u2sa.report.score.WaypointResult;

/**
 * Writes {@code track.kml} (OGC KML 2.2) for Google Earth: the track (of aircraft at true
 * altitude), the planned line and the waypoints.
 */
public final class TrackKml {

  private static final int MAX_POINTS = 10_000; // viewers slow down beyond this

  private static final String STYLES =
      """
      <Style id="flown"><LineStyle><color>ffb27200</color><width>3</width></LineStyle>\
      <PolyStyle><color>40b27200</color></PolyStyle></Style>
      <Style id="planned"><LineStyle><color>ff888888</color><width>2</width></LineStyle></Style>
      """;

  private static final String END_OF_LINE =
      "      </coordinates>\n    </LineString>\n  </Placemark>\n";

  private TrackKml() {}

  public static void write(
      Writer out, String title, RunPlan plan, RunScore score, List<TrackSample> track)
      throws IOException {
    KmlDocument.begin(out, title, STYLES);
    boolean flies = plan.domain() == Domain.AIR;
    if (!track.isEmpty()) {
      beginLine(out, plan.domain().moved(), "flown", flies, flies ? "extrude" : "tessellate");
      int step = 1 + track.size() / MAX_POINTS;
      for (int i = 0; i < track.size(); i += step) {
        TrackSample s = track.get(i);
        coordinates(out, s.longitudeDeg(), s.latitudeDeg(), s.altitudeM());
      }
      out.write(END_OF_LINE);
    }
    if (!plan.waypoints().isEmpty()) {
      beginLine(out, "planned", "planned", flies, "");
      planned(out, plan);
      out.write(END_OF_LINE);
    }
    for (WaypointResult result : score.waypoints()) {
      waypoint(out, result);
    }
    KmlDocument.end(out);
  }

  /**
   * @param joined KML element that joins the line to the ground, such as {@code extrude}; empty if
   *     none
   */
  private static void beginLine(Writer out, String name, String style, boolean flies, String joined)
      throws IOException {
    out.write(
        """
          <Placemark>
            <name>%s</name>
            <styleUrl>#%s</styleUrl>
            <LineString>
        """
            .formatted(name, style));
    out.write(joined.isEmpty() ? "" : "      <" + joined + ">1</" + joined + ">\n");
    String mode = flies ? KmlDocument.AT_ALTITUDE : KmlDocument.ON_THE_GROUND;
    out.write("      <altitudeMode>" + mode + "</altitudeMode>\n      <coordinates>\n");
  }

  private static void planned(Writer out, RunPlan plan) throws IOException {
    double altitude = plan.home().map(RunPlan.Start::altitudeM).orElse(0.0);
    if (plan.home().isPresent()) {
      coordinates(out, plan.home().get().longitudeDeg(), plan.home().get().latitudeDeg(), altitude);
    }
    for (RunPlan.Waypoint waypoint : plan.waypoints()) {
      altitude = waypoint.altitudeM().orElse(altitude);
      coordinates(out, waypoint.longitudeDeg(), waypoint.latitudeDeg(), altitude);
    }
  }

  private static void waypoint(Writer out, WaypointResult result) throws IOException {
    RunPlan.Waypoint waypoint = result.waypoint();
    KmlDocument.point(
        out,
        waypoint.name(),
        (result.captured() ? "captured" : "not captured")
            + number(", missed by %.1f m", result.missM())
            + number(", altitude error %+.1f m", result.altitudeErrorM()),
        waypoint.longitudeDeg(),
        waypoint.latitudeDeg(),
        waypoint.altitudeM());
  }

  private static String number(String pattern, OptionalDouble value) {
    return value.isPresent() ? String.format(Locale.ROOT, pattern, value.getAsDouble()) : "";
  }

  private static void coordinates(Writer out, double longitude, double latitude, double altitude)
      throws IOException {
    out.write(
        String.format(Locale.ROOT, "        %.7f,%.7f,%.2f\n", longitude, latitude, altitude));
  }
}
