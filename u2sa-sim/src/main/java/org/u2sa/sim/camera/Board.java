package org.u2sa.sim.camera;

/**
 * An upright two-sided rectangle: a sawhorse plank or a flag.
 *
 * @param x centre, east [m]
 * @param cos cosine of the angle from east to its long side
 * @param half half its length [m]
 * @param stripe width of diagonal stripes [m]; 0 for none
 */
record Board(
    float x,
    float y,
    float cos,
    float sin,
    float half,
    float low,
    float high,
    int colour,
    int other,
    float stripe)
    implements Solid {
  @Override
  public float[] column() {
    float middle = 0.5f * (low + high);
    return new float[] {x, y, middle, half, 0.5f * (high - low)};
  }

  @Override
  public float meets(float fromX, float fromY, float fromZ, float dx, float dy, float dz, Touch t) {
    float across = -dx * sin + dy * cos;
    float away = -(fromX - x) * sin + (fromY - y) * cos;
    float hit = -away / across;
    if (across == 0.0f || !(hit > 0.0f)) {
      return Float.POSITIVE_INFINITY;
    }
    float along = (fromX + hit * dx - x) * cos + (fromY + hit * dy - y) * sin;
    float z = fromZ + hit * dz;
    if (Math.abs(along) > half || z < low || z > high) {
      return Float.POSITIVE_INFINITY;
    }
    boolean second = stripe > 0.0f && ((int) Math.floor((along + z) / stripe) & 1) == 1;
    t.colour = second ? other : colour;
    float side = away > 0.0f ? 1.0f : -1.0f;
    t.nx = -sin * side;
    t.ny = cos * side;
    t.nz = 0.0f;
    return hit;
  }

  @Override
  public double[] shadow(double sunX, double sunY, double sunZ) {
    double[] points = new double[8];
    for (int i = 0; i < 4; i++) {
      double along = i % 2 == 0 ? half : -half;
      double up = i < 2 ? low : high;
      points[2 * i] = x + along * cos - sunX / sunZ * up;
      points[2 * i + 1] = y + along * sin - sunY / sunZ * up;
    }
    return points;
  }
}
