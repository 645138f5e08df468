package org.u2sa.world.sdf;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.Predicate;
import org.u2sa.messages.frame.Point;

/** Corners of the faces of a Wavefront OBJ file. */
final class ObjMesh {
  private final Predicate<String> wanted;
  private final List<Point> vertices = new ArrayList<>();
  private final BitSet used = new BitSet();
  private String group = "";

  private ObjMesh(Predicate<String> wanted) {
    this.wanted = wanted;
  }

  /**
   * Reads a file's text.
   *
   * @param wanted names of the objects and groups whose faces are read
   * @param corners receives each corner of a face once
   * @throws IOException naming the line that cannot be read
   */
  static void read(String text, Predicate<String> wanted, MeshCorners corners) throws IOException {
    ObjMesh mesh = new ObjMesh(wanted);
    BufferedReader lines = new BufferedReader(new StringReader(text));
    int number = 1;
    for (String line = lines.readLine(); line != null; line = lines.readLine(), number++) {
      int first = number;
      for (; line.endsWith("\\"); number++) { // continued in the next line
        String next = lines.readLine();
        line = line.substring(0, line.length() - 1) + " " + (next == null ? "" : next);
      }
      try {
        mesh.read(line.trim().split("\\s+"));
      } catch (IOException e) {
        throw new IOException("line " + first + ": " + e.getMessage(), e);
      }
    }
    for (int i = mesh.used.nextSetBit(0); i >= 0; i = mesh.used.nextSetBit(i + 1)) {
      Point each = mesh.vertices.get(i);
      corners.add(each.x(), each.y(), each.z());
    }
  }

  private void read(String... words) throws IOException {
    switch (words[0]) {
      case "v" -> {
        if (words.length < 4) {
          throw new IOException("expected v and three numbers");
        }
        double[] xyz = new double[3];
        for (int i = 0; i < xyz.length; i++) {
          xyz[i] = MeshCorners.number(words[i + 1]);
        }
        vertices.add(Point.of(xyz[0], xyz[1], xyz[2]));
      }
      case "o", "g" -> group = words.length > 1 ? words[1] : "";
      case "f" -> {
        for (int i = 1; i < words.length && wanted.test(group); i++) {
          used.set(index(words[i]));
        }
      }
      default -> {
        // normals, texture, materials, lines
      }
    }
  }

  /** Index of a face's corner such as 3/1/2: from 1, or backwards from the newest vertex at -1. */
  private int index(String corner) throws IOException {
    double given = MeshCorners.number(corner.split("/", 2)[0]);
    double index = given < 0.0 ? vertices.size() + given : given - 1.0;
    if (index != Math.rint(index) || index < 0.0 || index >= vertices.size()) {
      throw new IOException(
          "\"" + corner + "\": expected the number of one of " + vertices.size() + " vertices");
    }
    return (int) index;
  }
}
