package org.u2sa.sim.camera;

/** A solid on the ground for ray casting. World axes: east, north, up [m]. */
interface Solid {
  /** Intersection of a ray with a solid. Mutable and reused. */
  final class Touch {
    int colour;
    float nx; // outward surface normal
    float ny;
    float nz;
    boolean isGround; // coloured by the lawn map
    float cover; // share of the pixel, set by solids thinner than a pixel
    float pixel; // half the width of a pixel at distance 1, for such solids
  }

  /** Bounding column: centre east, north and up, radius, half height [m]. */
  float[] column();

  /**
   * Distance along a ray, in lengths of its direction; infinite for a miss.
   *
   * @param touch receives the intersection
   */
  float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch);

  /** Convex shadow outline on the ground, alternating x and y; empty for none. */
  double[] shadow(double sunX, double sunY, double sunZ);
}
