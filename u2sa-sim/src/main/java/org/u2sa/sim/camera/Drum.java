package org.u2sa.sim.camera;

/**
 * An upright cylinder with colour bands: a traffic barrel or a pole.
 *
 * @param bands band colours from the ground up, equal heights
 */
record Drum(float x, float y, float bottom, float radius, float height, int[] bands)
    implements Solid {
  private static final int CORNERS = 12;

  /** A traffic barrel: orange with two white bands and a rubber base. */
  static Drum barrel(double x, double y, double radius, double height) {
    int o = Reflectance.ORANGE;
    int w = Reflectance.WHITE;
    int[] bands = {Reflectance.RUBBER, o, o, w, w, o, o, w, w, o, o, o};
    return new Drum((float) x, (float) y, 0.0f, (float) radius, (float) height, bands);
  }

  @Override
  public float[] column() {
    return new float[] {x, y, bottom + 0.5f * height, radius, 0.5f * height};
  }

  @Override
  public float meets(float fromX, float fromY, float fromZ, float dx, float dy, float dz, Touch t) {
    float px = fromX - x;
    float py = fromY - y;
    float a = dx * dx + dy * dy;
    float b = px * dx + py * dy;
    float c = px * px + py * py - radius * radius;
    float root = b * b - a * c;
    if (root <= 0.0f || a == 0.0f) {
      return Float.POSITIVE_INFINITY;
    }
    float side = (-b - (float) Math.sqrt(root)) / a;
    float z = fromZ + side * dz - bottom;
    if (side > 0.0f && z >= 0.0f && z < height) {
      t.colour = bands[(int) (bands.length * z / height)];
      t.nx = (px + side * dx) / radius;
      t.ny = (py + side * dy) / radius;
      t.nz = 0.0f;
      return side;
    }
    float lid = (bottom + height - fromZ) / dz;
    float lx = px + lid * dx;
    float ly = py + lid * dy;
    if (dz < 0.0f && lid > 0.0f && lx * lx + ly * ly <= radius * radius) {
      t.colour = bands[bands.length - 1];
      t.nx = 0.0f;
      t.ny = 0.0f;
      t.nz = 1.0f;
      return lid;
    }
    return Float.POSITIVE_INFINITY;
  }

  @Override
  public double[] shadow(double sunX, double sunY, double sunZ) {
    double[] points = new double[4 * CORNERS];
    double awayX = -sunX / sunZ * height;
    double awayY = -sunY / sunZ * height;
    for (int i = 0; i < CORNERS; i++) {
      double angle = 2.0 * Math.PI * i / CORNERS;
      points[4 * i] = x + radius * StrictMath.cos(angle);
      points[4 * i + 1] = y + radius * StrictMath.sin(angle);
      points[4 * i + 2] = points[4 * i] + awayX;
      points[4 * i + 3] = points[4 * i + 1] + awayY;
    }
    return points;
  }
}
