package org.u2sa.sim.camera;

import org.u2sa.device.port.CameraFrame.Intrinsics;

/** Viewing direction of each pixel: right and down per unit ahead. Immutable. */
final class RayTable {
  private static final int ROUNDS = 20;

  final float[] right;
  final float[] down;

  RayTable(ColourLens lens) {
    Intrinsics pinhole = lens.intrinsics();
    int count = lens.width() * lens.height();
    right = new float[count];
    down = new float[count];
    for (int i = 0; i < count; i++) {
      double seenX = (i % lens.width() - pinhole.centreX()) / pinhole.focalX();
      double seenY = (i / lens.width() - pinhole.centreY()) / pinhole.focalY();
      double x = seenX;
      double y = seenY;
      boolean distorted = lens.k1() != 0.0 || lens.k2() != 0.0;
      for (int round = 0; distorted && round < ROUNDS; round++) { // undistorts by iteration
        double square = x * x + y * y;
        double by = 1.0 + square * (lens.k1() + square * lens.k2());
        x = seenX / by;
        y = seenY / by;
      }
      right[i] = (float) x;
      down[i] = (float) y;
    }
  }
}
