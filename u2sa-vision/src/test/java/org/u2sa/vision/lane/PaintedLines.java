package org.u2sa.vision.lane;

import java.util.List;
import org.u2sa.messages.frame.Point;

/** Painted lines as they are looked at in a test, ten times a second, with errors of 5 cm. */
final class PaintedLines {
  private static final double WANDER = 0.0025; // 5 cm in a second

  final LineSamples samples = new LineSamples();
  long micros;

  /** One picture of lines, each x and y of both its ends [m]. */
  void look(double... ends) {
    samples.begin(micros += 100_000, WANDER);
    for (int i = 0; i < ends.length; i += 4) {
      samples.enter(
          Point.of(ends[i], ends[i + 1], 0.0), Point.of(ends[i + 2], ends[i + 3], 0.0), 0.05, 0.35);
    }
  }

  void lookThrice(double... ends) {
    for (int i = 0; i < 3; i++) {
      look(ends);
    }
  }

  LineChains chains() {
    return LineChains.of(samples.certain(0.0, 0.0, 50.0, 3));
  }

  List<List<Point>> lines() {
    return chains().lines();
  }

  /** Distance between both ends of a line [m]. */
  static double length(List<Point> line) {
    return LineGeometry.metres(line.get(0), line.get(line.size() - 1));
  }

  /** Ends of straight pieces along an arc around the origin, from one angle to another. */
  static double[] arc(double radiusM, double fromRad, double toRad, int pieces) {
    double[] ends = new double[4 * pieces];
    for (int i = 0; i < pieces; i++) {
      for (int k = 0; k < 2; k++) {
        double angle = fromRad + (i + k) * (toRad - fromRad) / pieces;
        ends[4 * i + 2 * k] = radiusM * Math.cos(angle);
        ends[4 * i + 2 * k + 1] = radiusM * Math.sin(angle);
      }
    }
    return ends;
  }
}
