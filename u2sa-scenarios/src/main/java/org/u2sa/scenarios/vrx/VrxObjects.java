package org.u2sa.scenarios.vrx;

import static org.u2sa.scenarios.vrx.SdfValues.numbers;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Cylinder;

/** Buoys and other models included by a world, directly or through other models. */
final class VrxObjects {
  // mb_marker_buoy and mb_round_buoy of the models that the courses include
  private static final double MARKER_RADIUS_M = 0.325;
  private static final double ROUND_RADIUS_M = 0.25;
  private static final double MARKER_HEIGHT_M = 1.1;
  private static final double LIGHT_RADIUS_M = 0.75; // of the float, a 1.5 m square
  private static final double LIGHT_HEIGHT_M = 1.75;

  /**
   * A model of a world.
   *
   * @param model last part of its URI
   * @param place east, north [m]
   * @param yawRad anticlockwise from east
   */
  record Included(String model, Point place, double yawRad, XmlElement element) {}

  private static final int DEEPEST = 4; // maximum nesting of models
  private static final int MOST = 2_000; // maximum includes; a course has about ten

  private final Path file;
  private final Map<Path, XmlElement> models = new HashMap<>();
  private int includes;
  private final Map<String, Included> included = new LinkedHashMap<>(); // by name
  private final List<ObjectDescription> buoys = new ArrayList<>();

  VrxObjects(Path file, XmlElement world) {
    this.file = file;
    world.children("include").forEach(include -> include(include, Point.ORIGIN, 0.0, 0));
  }

  /** All buoys, in LOCAL_ENU. */
  List<ObjectDescription> buoys() {
    return List.copyOf(buoys);
  }

  /** The model named by an element, whose text may also name one of its links. */
  Included named(XmlElement name) {
    String text = name.text().trim();
    Included found = included.get(text.replaceFirst("::.*", ""));
    if (found == null) {
      throw name.error(
          "\""
              + text
              + "\": no such model; expected the name of an <include> in the world or its course in ../models");
    }
    return found;
  }

  /** The first model whose URI has this prefix. */
  Optional<Included> first(String model) {
    return included.values().stream().filter(each -> each.model.startsWith(model)).findFirst();
  }

  private void include(XmlElement include, Point at, double yawRad, int depth) {
    if (depth > DEEPEST || ++includes > MOST) {
      throw include.error(
          "expected at most " + DEEPEST + " models within models, and " + MOST + " <include>");
    }
    double[] pose = include.child("pose").map(each -> numbers(each, 6)).orElse(new double[6]);
    Point place =
        Point.of(
            at.x() + pose[0] * Math.cos(yawRad) - pose[1] * Math.sin(yawRad),
            at.y() + pose[0] * Math.sin(yawRad) + pose[1] * Math.cos(yawRad),
            0.0);
    String uri = include.requiredChild("uri").text().trim();
    String model = uri.substring(uri.lastIndexOf('/') + 1);
    String name = include.child("name").map(each -> each.text().trim()).orElse(model);
    included.put(name, new Included(model, place, yawRad + pose[5], include));
    if (model.contains("buoy")) {
      buoys.add(buoy(name, model, place));
      return;
    }
    modelFile(model)
        .map(each -> models.computeIfAbsent(each, sdf -> XmlReader.read(sdf, "sdf")))
        .ifPresent(
            root ->
                root.children("model").stream()
                    .flatMap(each -> each.children("include").stream())
                    .forEach(each -> include(each, place, yawRad + pose[5], depth + 1)));
  }

  private static ObjectDescription buoy(String name, String model, Point place) {
    boolean isRound = model.contains("round");
    boolean isLight = model.contains("light");
    Cylinder buoy =
        new Cylinder()
            .radius(isLight ? LIGHT_RADIUS_M : isRound ? ROUND_RADIUS_M : MARKER_RADIUS_M)
            .height(isLight ? LIGHT_HEIGHT_M : isRound ? ROUND_RADIUS_M : MARKER_HEIGHT_M);
    buoy.uid(name).objectType(kind(model)).referenceFrame(ReferenceFrame.LOCAL_ENU);
    buoy.x(place.x()).y(place.y()).z(0.0).freeze();
    return buoy;
  }

  /** Type that a detector reports for a model: "red marker", "black buoy", "light buoy". */
  private static String kind(String model) {
    String colour = model.substring(model.lastIndexOf('_') + 1);
    return model.contains("light")
        ? Docking.LIGHT
        : colour + (model.contains("round") ? " buoy" : " marker");
  }

  /** A model in a folder "models" beside the world's file or in a parent folder. */
  private Optional<Path> modelFile(String model) {
    Path folder = file.toAbsolutePath().normalize().getParent();
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
