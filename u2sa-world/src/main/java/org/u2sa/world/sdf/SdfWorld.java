package org.u2sa.world.sdf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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
  private static final int DEEPEST = 16; // maximum nesting of models

  private final ReadBudget budget = new ReadBudget();
  private final SdfResources resources;
  private final SdfGeometry geometry;
  private final List<ObjectDescription> objects = new ArrayList<>();
  private final List<String> ignored = new ArrayList<>();
  private final Map<String, Integer> names = new HashMap<>();

  private SdfWorld(Path file, Map<String, String> environment) {
    resources = new SdfResources(file, environment);
    geometry = new SdfGeometry(resources, budget, ignored);
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
    Path folder = file.toAbsolutePath().normalize().getParent();
    Optional<XmlElement> world = root.children("world").stream().findFirst();
    if (world.isPresent()) {
      read.all(world.get(), SdfPose.NONE, "", folder, read.states(world.get()), 0);
    } else {
      read.all(root, SdfPose.NONE, "", folder, Map.of(), 0);
    }
    return read;
  }

  /** Poses in which Gazebo's classic worlds were saved, by the model's name. */
  private Map<String, SdfPose> states(XmlElement world) {
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

  private void all(
      XmlElement parent,
      SdfPose frame,
      String path,
      Path folder,
      Map<String, SdfPose> states,
      int depth) {
    SdfFrames frames = new SdfFrames(parent, ignored);
    for (XmlElement child : parent.children()) {
      switch (child.name()) {
        case "model" -> {
          String name = child.optionalAttribute("name").orElse("model");
          SdfPose own = states.getOrDefault(name, frames.of(child, path + name));
          model(child, frame.then(own), path + name, folder, depth);
        }
        case "include" -> include(child, frames, frame, path, folder, states, depth);
        case "light", "actor", "road", "population", "joint", "plugin" -> {
          if (!path.isEmpty() || child.name().equals("plugin") || child.name().equals("light")) {
            continue; // nothing to collide with
          }
          ignored.add(child.name() + " in line " + child.line());
        }
        default -> {
          // physics, scene, state and other elements that are not objects
        }
      }
    }
  }

  private void model(XmlElement model, SdfPose frame, String path, Path folder, int depth) {
    if (depth > DEEPEST) {
      throw model.error("models are nested deeper than " + DEEPEST);
    }
    SdfFrames frames = new SdfFrames(model, ignored);
    for (XmlElement link : model.children("link")) {
      String name = path + "/" + link.optionalAttribute("name").orElse("link");
      List<XmlElement> solid = link.children("collision");
      for (XmlElement each : solid.isEmpty() ? link.children("visual") : solid) {
        each.child("geometry")
            .flatMap(
                shape ->
                    geometry.object(
                        shape, frame.then(frames.ofPart(each, link, name)), name, folder))
            .ifPresent(object -> add(object, path, each));
      }
    }
    all(model, frame, path + "/", folder, Map.of(), depth + 1);
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

  private void include(
      XmlElement include,
      SdfFrames frames,
      SdfPose frame,
      String path,
      Path folder,
      Map<String, SdfPose> states,
      int depth) {
    String uri = include.requiredChild("uri").text();
    String name = include.child("name").map(XmlElement::text).orElse(lastPart(uri));
    Optional<Path> file =
        resources
            .find(uri, folder)
            .map(found -> Files.isDirectory(found) ? found.resolve("model.sdf") : found)
            .filter(Files::isRegularFile)
            .filter(resources::isInside);
    if (file.isEmpty()) {
      ignored.add(name + ": model " + uri + " is not found");
      return;
    }
    if (depth > DEEPEST) {
      throw include.error("models are nested deeper than " + DEEPEST);
    }
    XmlElement root;
    take(file.get());
    try {
      root = XmlReader.read(file.get(), "sdf");
    } catch (BadInputException e) { // a third-party model may be faulty
      ignored.add(name + ": " + e.getMessage());
      return;
    }
    for (XmlElement model : root.children("model")) {
      SdfPose placed =
          include.child("pose").isPresent() ? frames.of(include, name) : SdfPose.of(model);
      SdfPose at = frame.then(states.getOrDefault(name, placed));
      model(model, at, path + name, file.get().getParent(), depth + 1);
    }
  }

  private void take(Path file) {
    try {
      budget.take(file);
    } catch (IOException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  private static String lastPart(String uri) {
    return uri.substring(uri.lastIndexOf('/') + 1);
  }

  /** The objects, with unique UIDs derived from their models' names. */
  public List<ObjectDescription> objects() {
    return List.copyOf(objects);
  }

  /** Elements of the file that do not become objects, and why. */
  public List<String> ignored() {
    return List.copyOf(ignored);
  }
}
