package org.u2sa.world.sdf;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Set;
import java.util.StringTokenizer;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;

/** Corners of a {@code <geometry>} of COLLADA: the positions that its faces and lines use. */
final class ColladaGeometry {
  private static final Set<String> PRIMITIVES =
      Set.of("triangles", "polylist", "polygons", "tristrips", "trifans", "lines", "linestrips");

  private final ColladaIds ids;

  ColladaGeometry(ColladaIds ids) {
    this.ids = ids;
  }

  /**
   * The corners, each once per list of faces.
   *
   * @throws org.u2sa.interfaces.BadInputException naming the element that cannot be read
   */
  List<Point> corners(XmlElement geometry) {
    List<Point> corners = new ArrayList<>();
    if (geometry.child("spline").isPresent()) {
      return corners; // a curve is not solid
    }
    for (XmlElement each : geometry.requiredChild("mesh").children()) {
      if (PRIMITIVES.contains(each.name())) {
        addCorners(each, corners);
      }
    }
    return corners;
  }

  private void addCorners(XmlElement primitive, List<Point> corners) {
    List<XmlElement> indices = new ArrayList<>(primitive.children("p"));
    primitive.children("ph").forEach(withHoles -> indices.addAll(withHoles.children("p")));
    if (indices.isEmpty()) {
      return;
    }
    int stride = 1;
    for (XmlElement input : primitive.children("input")) {
      stride = Math.max(stride, 1 + number(input, "offset", 0));
    }
    XmlElement vertex = input(primitive, "VERTEX");
    List<Point> positions =
        positions(
            ids.target(
                input(ids.target(vertex, "source", "vertices"), "POSITION"), "source", "source"));
    BitSet used = new BitSet();
    for (XmlElement p : indices) {
      int place = stride - number(vertex, "offset", 0);
      for (StringTokenizer words = new StringTokenizer(p.text()); words.hasMoreTokens(); place++) {
        String word = words.nextToken();
        if (place % stride == 0) {
          used.set(index(p, word, positions.size()));
        }
      }
    }
    used.stream().forEach(index -> corners.add(positions.get(index)));
  }

  private static int index(XmlElement p, String word, int count) {
    double index = SdfNumbers.parsed(p, word);
    if (index != Math.rint(index) || index < 0.0 || index >= count) {
      throw p.error("\"" + word + "\": expected the number of one of " + count + " positions");
    }
    return (int) index;
  }

  private static XmlElement input(XmlElement parent, String semantic) {
    return parent.children("input").stream()
        .filter(each -> each.attribute("semantic").equals(semantic))
        .findFirst()
        .orElseThrow(() -> parent.error("lacks <input semantic=\"" + semantic + "\">"));
  }

  private static List<Point> positions(XmlElement source) {
    XmlElement accessor =
        source.child("technique_common").flatMap(each -> each.child("accessor")).orElse(source);
    int stride = Math.max(3, number(accessor, "stride", 3));
    XmlElement array = source.requiredChild("float_array");
    StringTokenizer words = new StringTokenizer(array.text());
    for (int i = number(accessor, "offset", 0); i > 0 && words.hasMoreTokens(); i--) {
      words.nextToken();
    }
    List<Point> positions = new ArrayList<>();
    double[] xyz = new double[3];
    for (int at = 0; words.hasMoreTokens(); at = (at + 1) % stride) {
      String word = words.nextToken();
      if (at < 3) {
        xyz[at] = SdfNumbers.parsed(array, word);
      }
      if (at == 2) {
        positions.add(Point.of(xyz[0], xyz[1], xyz[2]));
      }
    }
    return positions;
  }

  private static int number(XmlElement element, String attribute, int usual) {
    String word = element.optionalAttribute(attribute).orElse(String.valueOf(usual));
    double number = SdfNumbers.parsed(element, word);
    if (number != Math.rint(number) || number < 0.0) {
      throw element.error(attribute + "=\"" + word + "\": expected a whole number, at least 0");
    }
    return (int) number;
  }
}
