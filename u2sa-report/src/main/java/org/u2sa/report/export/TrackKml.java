package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
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

  private TrackKml() {}

  public static void write(
      Writer out, String title, RunPlan plan, RunScore score, List<TrackSample> track)
      throws IOException {
    KmlText.begin(out, title, STYLES);
    boolean flies = plan.domain().flies();
    if (!track.isEmpty()) {
      List<GeoRun.Fix> moved = new ArrayList<>();
      int step = 1 + track.size() / MAX_POINTS;
      for (int i = 0; i < track.size(); i += step) {
        TrackSample s = track.get(i);
        moved.add(fix(s.longitudeDeg(), s.latitudeDeg(), s.altitudeM()));
      }
      line(out, plan.domain().moved(), "flown", flies, flies ? "extrude" : "tessellate", moved);
    }
    if (!plan.waypoints().isEmpty()) {
      line(out, "planned", "planned", flies, "", planned(plan));
    }
    for (WaypointResult result : score.waypoints()) {
      waypoint(out, result);
    }
    KmlText.end(out);
  }

  /**
   * Writes a line, cut at the antimeridian; {@code joined} is the element that joins it to the
   * ground.
   */
  private static void line(
      Writer out, String name, String style, boolean flies, String joined, List<GeoRun.Fix> fixes)
      throws IOException {
    List<List<GeoRun.Fix>> parts = TrackParts.of(fixes);
    out.write(
        """
          <Placemark>
            <name>%s</name>
            <styleUrl>#%s</styleUrl>
        """
            .formatted(name, style));
    out.write(parts.size() > 1 ? "    <MultiGeometry>\n" : "");
    String mode = flies ? KmlText.AT_ALTITUDE : KmlText.ON_THE_GROUND;
    for (List<GeoRun.Fix> part : parts) {
      out.write("    <LineString>\n");
      out.write(joined.isEmpty() ? "" : "      <" + joined + ">1</" + joined + ">\n");
      out.write("      <altitudeMode>" + mode + "</altitudeMode>\n      <coordinates>\n");
      for (GeoRun.Fix fix : part) {
        coordinates(out, fix);
      }
      out.write("      </coordinates>\n    </LineString>\n");
    }
    out.write(parts.size() > 1 ? "    </MultiGeometry>\n" : "");
    out.write("  </Placemark>\n");
  }

  private static List<GeoRun.Fix> planned(RunPlan plan) {
    List<GeoRun.Fix> planned = new ArrayList<>();
    double altitude = plan.home().map(RunPlan.Start::altitudeM).orElse(0.0);
    if (plan.home().isPresent()) {
      planned.add(fix(plan.home().get().longitudeDeg(), plan.home().get().latitudeDeg(), altitude));
    }
    for (RunPlan.Waypoint waypoint : plan.waypoints()) {
      altitude = waypoint.altitudeM().orElse(altitude);
      planned.add(fix(waypoint.longitudeDeg(), waypoint.latitudeDeg(), altitude));
    }
    return planned;
  }

  private static GeoRun.Fix fix(double longitudeDeg, double latitudeDeg, double altitudeM) {
    return new GeoRun.Fix(0L, longitudeDeg, latitudeDeg, OptionalDouble.of(altitudeM));
  }

  private static void waypoint(Writer out, WaypointResult result) throws IOException {
    RunPlan.Waypoint waypoint = result.waypoint();
    KmlText.point(
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

  private static void coordinates(Writer out, GeoRun.Fix fix) throws IOException {
    out.write(
        String.format(
            Locale.ROOT,
            "        %.7f,%.7f,%.2f\n",
            fix.longitudeDeg(),
            fix.latitudeDeg(),
            fix.altitudeM().orElse(0.0)));
  }
}
