package org.u2sa.world.sdf;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;

/** Reads corners of STL, OBJ and COLLADA meshes, of which only the convex hull matters. */
final class MeshPoints {
  private static final long LARGEST_BYTES = 64L << 20;
  private static final int STL_HEADER = 84;
  private static final int STL_FACET = 50;
  private static final int STL_NORMAL = 12;
  private static final String NUMBER = "\\s+([-+.\\deE]+)";
  private static final Pattern STL_VERTEX =
      Pattern.compile("(?i)vertex" + NUMBER + NUMBER + NUMBER);

  private MeshPoints() {}

  /**
   * Reads the corners of a mesh in its own units, those of COLLADA in metres.
   *
   * @param wanted names of the parts to be read; STL's has none: ""
   * @param budget for parts that a file contains several times
   * @throws IOException if it cannot be read, is too long, or is of another format
   */
  static List<Point> read(Path file, Predicate<String> wanted, ReadBudget budget)
      throws IOException {
    if (Files.size(file) > LARGEST_BYTES) {
      throw new IOException("has more than 64 MB");
    }
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    MeshCorners corners = new MeshCorners();
    if (name.endsWith(".stl")) {
      if (wanted.test("")) {
        readStl(Files.readAllBytes(file), corners);
      }
    } else if (name.endsWith(".obj")) {
      ObjMesh.read(new String(Files.readAllBytes(file), ISO_8859_1), wanted, corners);
    } else if (name.endsWith(".dae")) {
      try {
        ColladaMesh.read(file, wanted, budget, corners);
      } catch (BadInputException e) { // a third-party mesh may be faulty
        throw new IOException(e.getMessage(), e);
      }
    } else {
      throw new IOException("is neither STL, OBJ nor DAE");
    }
    List<Point> points = corners.points();
    if (points.isEmpty()) {
      throw new IOException("has no corners");
    }
    return points;
  }

  private static void readStl(byte[] bytes, MeshCorners corners) throws IOException {
    ByteBuffer stl = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    long facets =
        bytes.length < STL_HEADER ? -1 : Integer.toUnsignedLong(stl.getInt(STL_HEADER - 4));
    long length = STL_HEADER + facets * STL_FACET;
    String text = new String(bytes, ISO_8859_1);
    // Some programs begin binary files with "solid", others append to them.
    if (facets >= 0
        && (length == bytes.length || length < bytes.length && !text.startsWith("solid"))) {
      for (int i = 0; i < facets; i++) {
        int at = STL_HEADER + i * STL_FACET + STL_NORMAL;
        for (int corner = 0; corner < 3; corner++, at += 3 * Float.BYTES) {
          corners.add(stl.getFloat(at), stl.getFloat(at + 4), stl.getFloat(at + 8));
        }
      }
      return;
    }
    Matcher found = STL_VERTEX.matcher(text);
    while (found.find()) {
      corners.add(
          MeshCorners.number(found.group(1)),
          MeshCorners.number(found.group(2)),
          MeshCorners.number(found.group(3)));
    }
  }
}
