package org.u2sa.sim.camera;

/** Directions of one row's rays in the world (east, north, up). Mutable and reused. */
final class RayRow {
  final float[] dx;
  final float[] dy;
  final float[] dz;

  RayRow(int width) {
    dx = new float[width];
    dy = new float[width];
    dz = new float[width];
  }

  /**
   * Sets the directions of pixels from an index on.
   *
   * @param pose of the camera when the row is exposed
   */
  void aim(RayTable rays, int from, CameraPose pose) {
    aim(rays, from, pose, 0, dx);
    aim(rays, from, pose, 1, dy);
    aim(rays, from, pose, 2, dz);
  }

  private static void aim(RayTable rays, int from, CameraPose pose, int axis, float[] into) {
    float right = pose.right[axis];
    float below = pose.below[axis];
    float ahead = pose.axis[axis];
    for (int i = 0; i < into.length; i++) { // simple enough for the compiler to vectorize
      into[i] = rays.right[from + i] * right + rays.down[from + i] * below + ahead;
    }
  }
}
