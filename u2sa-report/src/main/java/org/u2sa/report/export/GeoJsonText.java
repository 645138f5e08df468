package org.u2sa.report.export;

import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.interfaces.JsonText;

/**
 * Formats GeoJSON (RFC 7946): one line per track, with the times of its positions in {@code
 * coordTimes}; several lines if the track crosses the antimeridian; one point per goal.
 */
public final class GeoJsonText {
  private static final double DEGREE_STEPS = 1e9;
  private static final double METRE_STEPS = 1e3;

  private GeoJsonText() {}

  public static void write(Writer out, GeoRun run) throws IOException {
    List<JsonText> features = new ArrayList<>();
    run.tracks().forEach((name, fixes) -> features.add(track(name, fixes)));
    run.goals().forEach(goal -> features.add(goal(goal)));
    JsonText all = new JsonText().put("type", "FeatureCollection").put("features", features);
    out.write(all.line());
    out.write("\n");
  }

  private static JsonText track(String name, List<GeoRun.Fix> fixes) {
    List<List<List<Double>>> lines = new ArrayList<>();
    List<List<String>> times = new ArrayList<>();
    for (List<GeoRun.Fix> part : TrackParts.of(fixes)) {
      lines.add(
          part.stream()
              .map(fix -> place(fix.longitudeDeg(), fix.latitudeDeg(), fix.altitudeM()))
              .collect(Collectors.toList()));
      times.add(part.stream().map(fix -> fix.time().toString()).collect(Collectors.toList()));
    }
    if (lines.size() > 1) {
      return feature(
          "MultiLineString", lines, new JsonText().put("name", name).put("coordTimes", times));
    }
    List<List<Double>> places = lines.get(0);
    boolean isLine = places.size() > 1; // RFC 7946, 3.1.4: two or more positions
    return feature(
        isLine ? "LineString" : "Point",
        isLine ? places : places.get(0),
        new JsonText().put("name", name).put("coordTimes", times.get(0)));
  }

  private static JsonText goal(GeoRun.Goal goal) {
    return feature(
        "Point",
        place(goal.longitudeDeg(), goal.latitudeDeg(), goal.altitudeM()),
        new JsonText()
            .put("name", goal.name())
            .put("thresholdM", goal.thresholdM())
            .put("reached", goal.isReached()));
  }

  private static JsonText feature(String geometry, List<?> coordinates, JsonText properties) {
    return new JsonText()
        .put("type", "Feature")
        .put("geometry", new JsonText().put("type", geometry).put("coordinates", coordinates))
        .put("properties", properties);
  }

  private static List<Double> place(double longitude, double latitude, OptionalDouble altitude) {
    List<Double> place = new ArrayList<>();
    place.add(Math.rint(longitude * DEGREE_STEPS) / DEGREE_STEPS);
    place.add(Math.rint(latitude * DEGREE_STEPS) / DEGREE_STEPS);
    if (altitude.isPresent()) {
      place.add(Math.rint(altitude.getAsDouble() * METRE_STEPS) / METRE_STEPS);
    }
    return place;
  }
}
