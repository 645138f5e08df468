package org.u2sa.world.sdf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/** Collects the corners of a mesh. */
final class MeshCorners {
  private final List<Point> points = new ArrayList<>();

  /**
   * Adds a corner.
   *
   * @throws IOException if a coordinate is not finite
   */
  void add(double x, double y, double z) throws IOException {
    points.add(Point.of(finite(x), finite(y), finite(z)));
  }

  List<Point> points() {
    return points;
  }

  /**
   * A number in a mesh file.
   *
   * @throws IOException unless the word is a finite number
   */
  static double number(String word) throws IOException {
    try {
      return finite(Double.parseDouble(word));
    } catch (NumberFormatException e) {
      throw new IOException("\"" + word + "\" is not a number", e);
    }
  }

  private static double finite(double number) throws IOException {
    if (!Double.isFinite(number)) {
      throw new IOException("has a corner with invalid coordinates");
    }
    return number;
  }
}
