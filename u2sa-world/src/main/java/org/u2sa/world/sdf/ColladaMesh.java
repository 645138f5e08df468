package org.u2sa.world.sdf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.Point;

/**
 * Corners of the scene of a COLLADA file in metres, as Gazebo places them: with the transformations
 * of all nodes and the unit, but without {@code <up_axis>}, which Gazebo does not apply.
 */
final class ColladaMesh {
  private static final int DEEPEST = 64; // maximum nesting of nodes
  private static final int POINT_BYTES = 24; // cost of a corner or node, like that of its numbers

  private final ColladaIds ids;
  private final ColladaGeometry geometries;
  private final Map<String, List<Point>> corners = new HashMap<>(); // by the geometry's id
  private final Predicate<String> wanted;
  private final ReadBudget budget;
  private final MeshCorners placed;

  private ColladaMesh(
      XmlElement root, Predicate<String> wanted, ReadBudget budget, MeshCorners placed) {
    ids = new ColladaIds(root);
    geometries = new ColladaGeometry(ids);
    this.wanted = wanted;
    this.budget = budget;
    this.placed = placed;
  }

  /**
   * Reads a file.
   *
   * @param wanted names of the nodes whose geometry is read
   * @param budget for nodes and geometries, which may be instantiated very often
   * @param placed receives the corners
   * @throws org.u2sa.interfaces.BadInputException naming the element that cannot be read
   * @throws IOException if a corner's coordinates are not finite
   */
  static void read(Path file, Predicate<String> wanted, ReadBudget budget, MeshCorners placed)
      throws IOException {
    XmlElement root = XmlReader.read(file, "COLLADA");
    ColladaMesh mesh = new ColladaMesh(root, wanted, budget, placed);
    Optional<XmlElement> unit = root.child("asset").flatMap(asset -> asset.child("unit"));
    double meter = unit.isPresent() ? meter(unit.get()) : 1.0;
    XmlElement instance = root.requiredChild("scene").requiredChild("instance_visual_scene");
    XmlElement scene = mesh.ids.target(instance, "url", "visual_scene");
    for (XmlElement node : scene.children("node")) {
      mesh.add(node, ColladaTransform.scale(meter, meter, meter), "", 0);
    }
  }

  private static double meter(XmlElement unit) {
    double meter = SdfNumbers.parsed(unit, unit.optionalAttribute("meter").orElse("1"));
    if (!(meter > 0.0)) {
      throw unit.error("meter=\"" + meter + "\": expected a number above 0");
    }
    return meter;
  }

  private void add(XmlElement node, ColladaTransform parent, String parentName, int depth)
      throws IOException {
    if (depth > DEEPEST) {
      throw node.error("nodes are nested deeper than " + DEEPEST + ", or in a circle");
    }
    budget.take(POINT_BYTES);
    ColladaTransform frame = parent.times(ColladaTransform.of(node));
    String name = node.optionalAttribute("name").orElse(parentName);
    for (XmlElement each : node.children()) {
      switch (each.name()) {
        case "node" -> add(each, frame, name, depth + 1);
        case "instance_node" -> add(ids.target(each, "url", "node"), frame, name, depth + 1);
        case "instance_geometry" -> place(each, "url", frame, name);
        case "instance_controller" -> {
          XmlElement controller = ids.target(each, "url", "controller");
          place(controller.requiredChild("skin"), "source", frame, name);
        }
        default -> {
          // transformations, cameras, lights
        }
      }
    }
  }

  private void place(XmlElement instance, String attribute, ColladaTransform frame, String name)
      throws IOException {
    if (!wanted.test(name)) {
      return;
    }
    XmlElement geometry = ids.target(instance, attribute, "geometry");
    List<Point> ofGeometry =
        corners.computeIfAbsent(geometry.attribute("id"), id -> geometries.corners(geometry));
    budget.take((long) POINT_BYTES * ofGeometry.size());
    for (Point corner : ofGeometry) {
      double[] p = frame.place(corner);
      placed.add(p[0], p[1], p[2]);
    }
  }
}
