package org.u2sa.scenarios.report;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.gcs.draw.Canvas.Pixel;

/** Lines as points a few pixels apart, for telling what a label would cover. */
final class Densified {

  private static final double SPACING = 6.0;

  private Densified() {}

  static List<Pixel> line(List<Pixel> corners) {
    List<Pixel> points = new ArrayList<>();
    for (int i = 0; i + 1 < corners.size(); i++) {
      Pixel a = corners.get(i);
      Pixel b = corners.get(i + 1);
      int parts = 1 + (int) (Math.hypot(b.x() - a.x(), b.y() - a.y()) / SPACING);
      for (int k = 0; k < parts; k++) {
        points.add(
            new Pixel(a.x() + (b.x() - a.x()) * k / parts, a.y() + (b.y() - a.y()) * k / parts));
      }
    }
    return points;
  }
}
