package org.u2sa.scenarios.suas;

import java.util.Map;

/** How targets look: outlines of shapes, in sides of the target, and colours. */
final class TargetLook {
  private static final Map<String, int[]> COLOURS =
      Map.of(
          "white", new int[] {235, 235, 235},
          "black", new int[] {25, 25, 25},
          "red", new int[] {200, 30, 35},
          "blue", new int[] {35, 60, 190},
          "yellow", new int[] {235, 215, 40},
          "orange", new int[] {240, 125, 25},
          "purple", new int[] {120, 40, 150});

  private TargetLook() {}

  static int[] rgb(String colour) {
    return COLOURS.get(colour);
  }

  /**
   * Whether a point is on a shape.
   *
   * @param right distance right of the middle, in sides
   * @param up distance above the middle, in sides
   */
  static boolean isOn(String shape, double right, double up) {
    return switch (shape) {
      case "circle" -> right * right + up * up < 0.25;
      case "square" -> Math.max(Math.abs(right), Math.abs(up)) < 0.45;
      case "triangle" -> isRegular(3, 0.6, right, up);
      case "pentagon" -> isRegular(5, 0.5, right, up);
      case "cross" ->
          Math.min(Math.abs(right), Math.abs(up)) < 0.27
              && Math.max(Math.abs(right), Math.abs(up)) < 0.6;
      case "star" -> isStar(right, up);
      default -> throw new IllegalArgumentException(shape);
    };
  }

  /** Whether a point is within a regular polygon with a corner at the top. */
  private static boolean isRegular(int corners, double radius, double right, double up) {
    double step = 2.0 * Math.PI / corners;
    double angle = Math.IEEEremainder(Math.atan2(right, up) - 0.5 * step, step);
    return Math.hypot(right, up) * Math.cos(angle) < radius * Math.cos(0.5 * step);
  }

  private static boolean isStar(double right, double up) {
    double step = 2.0 * Math.PI / 5.0;
    double angle = Math.abs(Math.IEEEremainder(Math.atan2(right, up), step)); // from a tip
    double outer = 0.7;
    double inner = 0.36;
    // the line from the point at angle 0 to the notch at half a step
    double x = inner * Math.cos(0.5 * step) - outer;
    double y = inner * Math.sin(0.5 * step);
    double px = Math.hypot(right, up) * Math.cos(angle) - outer;
    double py = Math.hypot(right, up) * Math.sin(angle);
    return x * py - y * px > 0.0;
  }
}
