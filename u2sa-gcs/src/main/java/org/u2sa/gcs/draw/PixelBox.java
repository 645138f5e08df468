package org.u2sa.gcs.draw;

/** An upright rectangle of the canvas [px]; (x, y) is its upper left corner, y grows downwards. */
public record PixelBox(double x, double y, double width, double height) {

  public double right() {
    return x + width;
  }

  public double bottom() {
    return y + height;
  }

  public boolean contains(double px, double py) {
    return px >= x && px <= right() && py >= y && py <= bottom();
  }

  /** Whether {@code other} lies wholly within. */
  public boolean contains(PixelBox other) {
    return other.x >= x && other.right() <= right() && other.y >= y && other.bottom() <= bottom();
  }

  /** Area common with {@code other} [px²]. */
  public double overlap(PixelBox other) {
    double w = Math.min(right(), other.right()) - Math.max(x, other.x);
    double h = Math.min(bottom(), other.bottom()) - Math.max(y, other.y);
    return w > 0.0 && h > 0.0 ? w * h : 0.0;
  }
}
