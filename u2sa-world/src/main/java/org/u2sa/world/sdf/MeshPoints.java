package org.u2sa.world.sdf;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.messages.frame.Point;

/** Reads corners of STL, OBJ and COLLADA meshes, of which only the convex hull matters. */
final class MeshPoints {
  private static final long LARGEST_BYTES = 64L << 20;
  private static final int STL_HEADER = 84;
  private static final int STL_FACET = 50;
  private static final int STL_NORMAL = 12;
  private static final String NUMBER = "\\s+([-+.\\deE]+)";
  private static final Pattern STL_VERTEX = Pattern.compile("vertex" + NUMBER + NUMBER + NUMBER);
  private static final Pattern OBJ_VERTEX = Pattern.compile("(?m)^v" + NUMBER + NUMBER + NUMBER);
  private static final String DAE_ARRAY = "<float_array";
  private static final Pattern DAE_POSITION = Pattern.compile("id=\"[^\"]*[Pp]osition");
  private static final int LONGEST_TAG = 1_000;

  private MeshPoints() {}

  /**
   * Reads the corners of a mesh in its own units.
   *
   * @throws IOException if it cannot be read, is too long, or is of another format
   */
  static List<Point> read(Path file) throws IOException {
    if (Files.size(file) > LARGEST_BYTES) {
      throw new IOException("has more than 64 MB");
    }
    byte[] bytes = Files.readAllBytes(file);
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    List<Point> points = new ArrayList<>();
    if (name.endsWith(".stl")) {
      readStl(bytes, points);
    } else if (name.endsWith(".obj")) {
      match(OBJ_VERTEX, new String(bytes, ISO_8859_1), points);
    } else if (name.endsWith(".dae")) {
      readCollada(new String(bytes, ISO_8859_1), points);
    } else {
      throw new IOException("is neither STL, OBJ nor DAE");
    }
    if (points.isEmpty()) {
      throw new IOException("has no corners");
    }
    return points;
  }

  private static void readStl(byte[] bytes, List<Point> points) throws IOException {
    ByteBuffer stl = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    long facets =
        bytes.length < STL_HEADER ? -1 : Integer.toUnsignedLong(stl.getInt(STL_HEADER - 4));
    if (facets >= 0 && STL_HEADER + facets * STL_FACET == bytes.length) {
      for (int i = 0; i < facets; i++) {
        int at = STL_HEADER + i * STL_FACET + STL_NORMAL;
        for (int corner = 0; corner < 3; corner++, at += 3 * Float.BYTES) {
          add(stl.getFloat(at), stl.getFloat(at + 4), stl.getFloat(at + 8), points);
        }
      }
    } else {
      match(STL_VERTEX, new String(bytes, ISO_8859_1), points);
    }
  }

  /** Does not use a pattern, which would backtrack excessively in a file with unclosed tags. */
  private static void readCollada(String text, List<Point> points) throws IOException {
    int tagEnd = -1;
    int next;
    for (int at = text.indexOf(DAE_ARRAY); at >= 0; at = next) {
      next = text.indexOf(DAE_ARRAY, at + 1);
      tagEnd = tagEnd < at ? text.indexOf('>', at) : tagEnd;
      if (tagEnd < 0) {
        return;
      }
      boolean isTag = next < 0 || tagEnd < next;
      if (isTag
          && tagEnd - at < LONGEST_TAG
          && DAE_POSITION.matcher(text.substring(at, tagEnd)).find()) {
        int end = text.indexOf('<', tagEnd);
        readPositions(text.substring(tagEnd + 1, end < 0 ? text.length() : end), points);
      }
    }
  }

  private static void readPositions(String numbers, List<Point> points) throws IOException {
    String[] words = numbers.trim().split("\\s+");
    for (int i = 0; i + 2 < words.length; i += 3) {
      add(number(words[i]), number(words[i + 1]), number(words[i + 2]), points);
    }
  }

  private static void match(Pattern pattern, String text, List<Point> points) throws IOException {
    Matcher found = pattern.matcher(text);
    while (found.find()) {
      add(number(found.group(1)), number(found.group(2)), number(found.group(3)), points);
    }
  }

  private static double number(String word) throws IOException {
    try {
      return Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw new IOException("\"" + word + "\" is not a number", e);
    }
  }

  private static void add(double x, double y, double z, List<Point> points) throws IOException {
    if (!Double.isFinite(x + y + z)) {
      throw new IOException("has a corner with invalid coordinates");
    }
    points.add(Point.of(x, y, z));
  }
}
