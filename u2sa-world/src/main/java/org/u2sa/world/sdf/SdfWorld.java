package org.u2sa.world.sdf;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * A world of Gazebo as objects in LOCAL_ENU about its origin: x east, y north, z up. Uses each
 * link's collisions, or its visuals if it has none. All objects are static at the positions in the
 * file.
 */
public final class SdfWorld {
  private static final int MAX_OBJECTS = 100_000;

  private final SdfIncludes includes;
  private final SdfGeometry geometry;
  private final List<ObjectDescription> objects = new ArrayList<>();
  private final SdfOmissions omissions = new SdfOmissions();
  private final Map<String, Integer> names = new HashMap<>();

  private SdfWorld(Path file, Map<String, String> environment) {
    SdfResources resources = new SdfResources(file, environment);
    ReadBudget budget = new ReadBudget(file);
    includes = new SdfIncludes(resources, budget, omissions);
    geometry = new SdfGeometry(new SdfMesh(resources, budget), omissions);
  }

  /** Whether a file is to be read as SDFormat, by its name. */
  public static boolean isSdf(Path file) {
    String name = file.getFileName().toString();
    return name.endsWith(".sdf") || name.endsWith(".world");
  }

  /**
   * Reads the world or model of a file.
   *
   * @param environment variables that name folders of models, like Gazebo's
   * @throws BadInputException naming file, line, element, value and what was expected
   */
  public static SdfWorld read(Path file, Map<String, String> environment) {
    SdfWorld read = new SdfWorld(file, environment);
    XmlElement root = XmlReader.read(file, "sdf");
    XmlElement scope = root.children("world").stream().findFirst().orElse(root);
    read.all(read.includes.expanded(scope), SdfPose.NONE, "", states(scope));
    return read;
  }

  /** Poses in which Gazebo's classic worlds were saved, by the model's name. */
  private static Map<String, SdfPose> states(XmlElement world) {
    Map<String, SdfPose> states = new HashMap<>();
    for (XmlElement state : world.children("state")) {
      for (XmlElement model : state.children("model")) {
        model
            .child("pose")
            .ifPresent(pose -> states.put(model.attribute("name"), SdfPose.read(pose)));
      }
    }
    return states;
  }

  private void all(XmlElement parent, SdfPose frame, String path, Map<String, SdfPose> states) {
    SdfFrames frames = new SdfFrames(parent, omissions);
    for (XmlElement child : parent.children()) {
      switch (child.name()) {
        case "model" -> {
          String name = child.optionalAttribute("name").orElse("model");
          SdfPose saved = states.get(name);
          SdfPose own = saved == null ? frames.of(child, path + name) : saved;
          model(child, frame.then(own), path + name);
        }
        case "actor", "population" -> {
          if (path.isEmpty()) {
            omissions.obstacle(child.name() + " in line " + child.line());
          }
        }
        case "road", "joint" -> {
          if (path.isEmpty()) {
            omissions.harmless(child.name() + " in line " + child.line());
          }
        }
        default -> {
          // physics, scene, light, state and other elements that are not objects
        }
      }
    }
  }

  private void model(XmlElement model, SdfPose frame, String path) {
    SdfFrames frames = new SdfFrames(model, omissions);
    for (XmlElement link : model.children("link")) {
      String name = path + "/" + link.optionalAttribute("name").orElse("link");
      List<XmlElement> solid = link.children("collision");
      for (XmlElement each : solid.isEmpty() ? link.children("visual") : solid) {
        each.child("geometry")
            .flatMap(
                shape -> geometry.object(shape, frame.then(frames.ofPart(each, link, name)), name))
            .ifPresent(object -> add(object, path, each));
      }
    }
    all(model, frame, path + "/", Map.of());
  }

  private void add(ObjectDescription object, String name, XmlElement element) {
    if (objects.size() >= MAX_OBJECTS) {
      throw element.error("the world has more than " + MAX_OBJECTS + " objects");
    }
    int number = names.merge(name, 1, Integer::sum);
    object.uid(number == 1 ? name : name + " " + number);
    object.referenceFrame(ReferenceFrame.LOCAL_ENU);
    object.freeze();
    objects.add(object);
  }

  /** The objects, with unique UIDs derived from their models' names. */
  public List<ObjectDescription> objects() {
    return List.copyOf(objects);
  }

  /** Elements of the file that do not become objects, and why. */
  public List<String> ignored() {
    return omissions.all();
  }

  /** Those of {@link #ignored()} that may stand in the way. */
  public List<String> missing() {
    return omissions.obstacles();
  }
}
