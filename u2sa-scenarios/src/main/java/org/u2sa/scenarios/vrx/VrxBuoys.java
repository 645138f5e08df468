package org.u2sa.scenarios.vrx;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;

/** Buoys that a world of VRX includes, itself or by the models of its course. */
final class VrxBuoys {
  // mb_marker_buoy and mb_round_buoy of the models that the courses include
  private static final double MARKER_RADIUS_M = 0.325;
  private static final double ROUND_RADIUS_M = 0.25;
  private static final double MARKER_HEIGHT_M = 1.1;

  private static final int MAX_DEPTH = 4; // models within models
  private static final int MAX_INCLUDES = 2_000; // includes; a course has some ten

  private final Path world;
  private final Map<Path, XmlElement> models = new HashMap<>();
  private final Map<String, Point> places = new HashMap<>(); // by name
  private final List<ObjectDescription> buoys = new ArrayList<>();
  private int includes;

  VrxBuoys(Path world) {
    this.world = world;
  }

  List<ObjectDescription> all() {
    return List.copyOf(buoys);
  }

  /** Place of a buoy: east, north of the world's origin [m]. */
  Optional<Point> place(String name) {
    return Optional.ofNullable(places.get(name));
  }

  /** Adds the buoys of an included model, and those that it includes. */
  void include(XmlElement include) {
    include(include, Point.ORIGIN, 0.0, 0);
  }

  private void include(XmlElement include, Point at, double yawRad, int depth) {
    if (depth > MAX_DEPTH || ++includes > MAX_INCLUDES) {
      throw include.error(
          "expected at most "
              + MAX_DEPTH
              + " models within models, and "
              + MAX_INCLUDES
              + " <include>");
    }
    double[] pose =
        include.child("pose").map(each -> VrxWorldReader.numbers(each, 6)).orElse(new double[6]);
    Point place =
        Point.of(
            at.x() + pose[0] * Math.cos(yawRad) - pose[1] * Math.sin(yawRad),
            at.y() + pose[0] * Math.sin(yawRad) + pose[1] * Math.cos(yawRad),
            0.0);
    String uri = VrxWorldReader.required(include, "uri").text().trim();
    String model = uri.substring(uri.lastIndexOf('/') + 1);
    String name = include.child("name").map(each -> each.text().trim()).orElse(model);
    if (model.contains("buoy")) {
      add(name, model, place);
      return;
    }
    modelFile(model)
        .map(each -> models.computeIfAbsent(each, file -> XmlReader.read(file, "sdf")))
        .ifPresent(
            root ->
                root.children("model").stream()
                    .flatMap(each -> each.children("include").stream())
                    .forEach(each -> include(each, place, yawRad + pose[5], depth + 1)));
  }

  private void add(String name, String model, Point place) {
    places.put(name, place);
    boolean isRound = model.contains("round");
    double radiusM = isRound ? ROUND_RADIUS_M : MARKER_RADIUS_M;
    ObjectDescription buoy =
        new Cylinder().radius(radiusM).height(isRound ? radiusM : MARKER_HEIGHT_M);
    buoy.uid(name).objectType(model).referenceFrame(ReferenceFrame.LOCAL_ENU);
    buoy.x(place.x()).y(place.y()).z(0.0).freeze();
    buoys.add(buoy);
  }

  /** A model beside the worlds: in a folder "models" of the world's folder or of one above. */
  private Optional<Path> modelFile(String model) {
    Path folder = world.toAbsolutePath().normalize().getParent();
    for (int i = 0; i < 3 && folder != null; i++) {
      Path candidate = folder.resolve("models").resolve(model).resolve("model.sdf");
      if (Files.isRegularFile(candidate)) {
        return Optional.of(candidate);
      }
      folder = folder.getParent();
    }
    return Optional.empty();
  }
}
