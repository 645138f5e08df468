package org.u2sa.gcs.draw;

import java.awt.Color;

/** A line's colour, width [px] and dash length [px], 0 for solid. */
public record Stroke(Color color, double width, double dash) {

  public static Stroke solid(Color color, double width) {
    return new Stroke(color, width, 0.0);
  }

  public static Stroke dashed(Color color, double width, double dash) {
    return new Stroke(color, width, dash);
  }
}
