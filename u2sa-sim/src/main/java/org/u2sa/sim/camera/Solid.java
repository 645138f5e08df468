package org.u2sa.sim.camera;

/**
 * Something that stands on the ground, as a camera's rays meet it. World axes: east, north, up [m].
 */
interface Solid {
  /** Where a ray meets it. Reused from ray to ray. */
  final class Touch {
    int colour;
    float nx; // of the surface, outwards
    float ny;
    float nz;
    boolean isGround; // its colour is that of the lawn's map there
  }

  /**
   * An upright column around it: its middle east, north and up, its radius, half its height [m].
   */
  float[] column();

  /**
   * Distance along a ray to it, in lengths of its direction; infinite if they do not meet.
   *
   * @param touch takes what is there
   */
  float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch);

  /**
   * What it hides of the sun: an outline on the ground, x and y in turn, convex; empty: nothing.
   */
  double[] shadow(double sunX, double sunY, double sunZ);
}
