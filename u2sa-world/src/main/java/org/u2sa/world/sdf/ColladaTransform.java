package org.u2sa.world.sdf;

import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;

/** An affine map, as nodes of COLLADA scenes have: it may scale and shear. Immutable. */
final class ColladaTransform {
  private static final int MATRIX = 16;
  private static final int ROW = 4;

  private final double[] m; // three rows of four, the last column in the parent's units

  private ColladaTransform(double... m) {
    this.m = m;
  }

  static ColladaTransform scale(double x, double y, double z) {
    return new ColladaTransform(x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0);
  }

  /**
   * From a node's axes to its parent's: its transformations in the order of the file, the first
   * outermost.
   *
   * @throws org.u2sa.interfaces.BadInputException at {@code <skew>}, {@code <lookat>} and false
   *     numbers
   */
  static ColladaTransform of(XmlElement node) {
    ColladaTransform product = scale(1.0, 1.0, 1.0);
    for (XmlElement each : node.children()) {
      switch (each.name()) {
        case "matrix" -> product = product.times(new ColladaTransform(SdfNumbers.of(each, MATRIX)));
        case "translate" -> product = product.times(translation(SdfNumbers.of(each, 3)));
        case "rotate" -> product = product.times(rotation(each));
        case "scale" -> {
          double[] n = SdfNumbers.of(each, 3);
          product = product.times(scale(n[0], n[1], n[2]));
        }
        case "skew", "lookat" ->
            throw each.error("expected <matrix>, <translate>, <rotate> or <scale>");
        default -> {
          // not a transformation
        }
      }
    }
    return product;
  }

  private static ColladaTransform translation(double... n) {
    return new ColladaTransform(1, 0, 0, n[0], 0, 1, 0, n[1], 0, 0, 1, n[2]);
  }

  /** Rodrigues' formula; the angle is in degrees. */
  private static ColladaTransform rotation(XmlElement rotate) {
    double[] n = SdfNumbers.of(rotate, ROW);
    double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0.0)) {
      throw rotate.error("\"" + rotate.text() + "\": expected an axis other than 0 0 0");
    }
    double x = n[0] / length;
    double y = n[1] / length;
    double z = n[2] / length;
    double sin = Math.sin(Math.toRadians(n[3]));
    double cos = Math.cos(Math.toRadians(n[3]));
    double k = 1.0 - cos;
    return new ColladaTransform(
        cos + k * x * x,
        k * x * y - sin * z,
        k * x * z + sin * y,
        0,
        k * x * y + sin * z,
        cos + k * y * y,
        k * y * z - sin * x,
        0,
        k * x * z - sin * y,
        k * y * z + sin * x,
        cos + k * z * z,
        0);
  }

  /** Composition: {@code inner} first, then this. */
  ColladaTransform times(ColladaTransform inner) {
    double[] product = new double[3 * ROW];
    for (int row = 0; row < 3 * ROW; row += ROW) {
      for (int column = 0; column < ROW; column++) {
        double sum = column == 3 ? m[row + 3] : 0.0;
        for (int k = 0; k < 3; k++) {
          sum += m[row + k] * inner.m[ROW * k + column];
        }
        product[row + column] = sum;
      }
    }
    return new ColladaTransform(product);
  }

  /** A point in the outer axes; its coordinates overflow in an absurd file. */
  double[] place(Point p) {
    double[] placed = new double[3];
    for (int row = 0; row < 3; row++) {
      int at = ROW * row;
      placed[row] = m[at] * p.x() + m[at + 1] * p.y() + m[at + 2] * p.z() + m[at + 3];
    }
    return placed;
  }
}
