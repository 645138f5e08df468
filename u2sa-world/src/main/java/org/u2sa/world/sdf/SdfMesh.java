package org.u2sa.world.sdf;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;

/** Corners of SDFormat's {@code <mesh>}: of the whole file or a submesh, centred and scaled. */
final class SdfMesh {
  private final SdfResources resources;
  private final ReadBudget budget;

  SdfMesh(SdfResources resources, ReadBudget budget) {
    this.resources = resources;
    this.budget = budget;
  }

  /**
   * The corners in the frame of the collision or visual.
   *
   * @throws IOException if the mesh is not found or cannot be read; the message continues its name
   */
  List<Point> points(XmlElement mesh) throws IOException {
    Optional<Path> file = resources.find(mesh.requiredChild("uri").text(), mesh);
    if (file.isEmpty()) {
      throw new IOException(" is not found");
    }
    Optional<XmlElement> submesh = mesh.child("submesh");
    Optional<String> part = submesh.map(each -> each.requiredChild("name").text());
    List<Point> points;
    try {
      budget.take(file.get());
      points =
          MeshPoints.read(file.get(), name -> part.isEmpty() || part.get().equals(name), budget);
    } catch (IOException e) {
      String which = part.map(name -> ", submesh " + name + ": ").orElse(": ");
      throw new IOException(which + e.getMessage(), e);
    }
    boolean centred =
        submesh.flatMap(each -> each.child("center")).filter(SdfNumbers::isTrue).isPresent();
    Point center = centred ? center(points) : Point.ORIGIN;
    double[] scale =
        mesh.child("scale").map(each -> SdfNumbers.of(each, 3)).orElse(new double[] {1, 1, 1});
    List<Point> scaled = new ArrayList<>();
    for (Point point : points) {
      Point p = point.minus(center);
      scaled.add(Point.of(scale[0] * p.x(), scale[1] * p.y(), scale[2] * p.z()));
    }
    return scaled;
  }

  /** Centre of the box around points. */
  private static Point center(List<Point> points) {
    return Point.of(middle(points, Point::x), middle(points, Point::y), middle(points, Point::z));
  }

  private static double middle(List<Point> points, ToDoubleFunction<Point> coordinate) {
    double low = points.stream().mapToDouble(coordinate).min().orElse(0.0);
    double high = points.stream().mapToDouble(coordinate).max().orElse(0.0);
    return (low + high) / 2.0;
  }
}
