package org.u2sa.sim.camera;

import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Viewing direction of each pixel: right and down per unit ahead. Immutable. */
final class RayTable {
  private static final int ROUNDS = 20;

  final float[] right;
  final float[] down;

  private final ColourLens lens;

  RayTable(ColourLens lens) {
    this.lens = lens;
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

  View from(VehicleTruth truth) {
    return new View(truth);
  }

  /** The rays of a camera on a vehicle, in LOCAL_ENU. */
  final class View {
    final Point from;
    private final Point axis;
    private final Point rightwards;
    private final Point downwards;

    private View(VehicleTruth truth) {
      Rotation turn = truth.attitude().nedFromFrd();
      double sin = StrictMath.sin(lens.downRad());
      double cos = StrictMath.cos(lens.downRad());
      Point mounted = Point.of(lens.forwardM(), -lens.leftM(), -lens.upM());
      from = truth.position().plus(turn.times(mounted).axesExchanged());
      axis = turn.times(Point.of(cos, 0.0, sin)).axesExchanged();
      rightwards = turn.times(Point.of(0.0, 1.0, 0.0)).axesExchanged();
      downwards = turn.times(Point.of(-sin, 0.0, cos)).axesExchanged();
    }

    /** Direction of a pixel's ray, of length 1. */
    Point way(int pixel) {
      Point ray = axis.plus(rightwards.times(right[pixel])).plus(downwards.times(down[pixel]));
      return ray.times(1.0 / ray.distance());
    }
  }
}
