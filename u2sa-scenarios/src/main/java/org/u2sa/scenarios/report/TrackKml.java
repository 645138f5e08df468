package org.u2sa.scenarios.report;

import java.io.IOException;
import java.io.Writer;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * Writes {@code track.kml} (OGC KML 2.2) for Google Earth: the track, of aircraft at its true
 * altitude, the planned line, and the waypoints.
 */
final class TrackKml {

  private static final int MOST_POINTS = 10_000; // viewers slow down beyond

  private TrackKml() {}

  static void write(Writer out, String title, RunPlan plan, RunScore score, List<TrackSample> track)
      throws IOException {
    out.write(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n");
    out.write("  <name>" + EscapedXml.of(title) + "</name>\n");
    // KML colours are alpha, blue, green, red
    out.write(
        "  <Style id=\"flown\"><LineStyle><color>ffb27200</color><width>3</width></LineStyle>");
    out.write("<PolyStyle><color>40b27200</color></PolyStyle></Style>\n");
    out.write(
        "  <Style id=\"planned\"><LineStyle><color>ff888888</color><width>2</width></LineStyle></Style>\n");
    track(out, plan.domain(), track);
    planned(out, plan);
    for (WaypointResult result : score.waypoints()) {
      waypoint(out, result);
    }
    out.write("</Document>\n</kml>\n");
  }

  private static void track(Writer out, Domain domain, List<TrackSample> track) throws IOException {
    if (track.isEmpty()) {
      return;
    }
    out.write(
        "  <Placemark>\n    <name>"
            + domain.moved()
            + "</name>\n    <styleUrl>#flown</styleUrl>\n    <LineString>\n");
    out.write(
        domain == Domain.AIR
            ? "      <extrude>1</extrude>\n      <altitudeMode>absolute</altitudeMode>\n"
            : "      <tessellate>1</tessellate>\n      <altitudeMode>clampToGround</altitudeMode>\n");
    out.write("      <coordinates>\n");
    int step = 1 + track.size() / MOST_POINTS;
    for (int i = 0; i < track.size(); i += step) {
      TrackSample s = track.get(i);
      coordinates(out, s.longitudeDeg(), s.latitudeDeg(), s.altitudeM());
    }
    out.write("      </coordinates>\n    </LineString>\n  </Placemark>\n");
  }

  private static void planned(Writer out, RunPlan plan) throws IOException {
    if (plan.waypoints().isEmpty()) {
      return;
    }
    out.write(
        "  <Placemark>\n    <name>planned</name>\n    <styleUrl>#planned</styleUrl>\n    <LineString>\n");
    out.write(
        plan.domain() == Domain.AIR
            ? "      <altitudeMode>absolute</altitudeMode>\n"
            : "      <altitudeMode>clampToGround</altitudeMode>\n");
    out.write("      <coordinates>\n");
    double altitude = plan.home().map(RunPlan.Start::altitudeM).orElse(0.0);
    if (plan.home().isPresent()) {
      coordinates(out, plan.home().get().longitudeDeg(), plan.home().get().latitudeDeg(), altitude);
    }
    for (RunPlan.Waypoint waypoint : plan.waypoints()) {
      altitude = waypoint.altitudeM().orElse(altitude);
      coordinates(out, waypoint.longitudeDeg(), waypoint.latitudeDeg(), altitude);
    }
    out.write("      </coordinates>\n    </LineString>\n  </Placemark>\n");
  }

  private static void waypoint(Writer out, WaypointResult result) throws IOException {
    RunPlan.Waypoint waypoint = result.waypoint();
    out.write(
        "  <Placemark>\n    <name>"
            + EscapedXml.of(waypoint.name())
            + "</name>\n    <description>");
    out.write(result.captured() ? "captured" : "not captured");
    out.write(
        number(", missed by %.1f m", result.missM())
            + number(", altitude error %+.1f m", result.altitudeErrorM()));
    out.write("</description>\n    <Point>\n      <altitudeMode>");
    out.write(waypoint.altitudeM().isPresent() ? "absolute" : "clampToGround");
    out.write("</altitudeMode>\n      <coordinates>\n");
    coordinates(
        out, waypoint.longitudeDeg(), waypoint.latitudeDeg(), waypoint.altitudeM().orElse(0.0));
    out.write("      </coordinates>\n    </Point>\n  </Placemark>\n");
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
