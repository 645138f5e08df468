package org.u2sa.sim.camera;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.world.Ramp;

/**
 * A {@link Ramp} for the renderer. Paint on the lawn map below is projected vertically onto the
 * ramp, which stretches it by 1 % at 15 % slope. It casts no shadow.
 */
final class Boards implements Solid {
  private static final double[] NO_SHADOW = {};

  private final Ramp ramp;

  Boards(Ramp ramp) {
    this.ramp = ramp;
  }

  @Override
  public float[] column() {
    Point middle = ramp.at(0.5 * ramp.lengthM(), 0.0);
    double radius = 0.5 * Math.hypot(ramp.lengthM(), ramp.widthM());
    float half = 0.5f * (float) ramp.highestM();
    return new float[] {(float) middle.x(), (float) middle.y(), half, (float) radius, half};
  }

  @Override
  public float meets(float x, float y, float z, float dx, float dy, float dz, Touch touch) {
    double[] normal = new double[3];
    double hit = ramp.meets(x, y, z, dx, dy, dz, normal);
    if (hit > 0.0 && hit < Double.POSITIVE_INFINITY) {
      touch.nx = (float) normal[0];
      touch.ny = (float) normal[1];
      touch.nz = (float) normal[2];
      touch.isGround = normal[2] > 0.0;
      touch.colour = Reflectance.WOOD;
      return (float) hit;
    }
    return Float.POSITIVE_INFINITY;
  }

  @Override
  public double[] shadow(double sunX, double sunY, double sunZ) {
    return NO_SHADOW;
  }

  /** Outline from above, anticlockwise: alternating east and north [m]. */
  double[] outline() {
    double half = 0.5 * ramp.widthM();
    double[] corners = new double[8];
    double[] along = {0.0, ramp.lengthM(), ramp.lengthM(), 0.0};
    double[] left = {-half, -half, half, half};
    for (int i = 0; i < along.length; i++) {
      Point at = ramp.at(along[i], left[i]);
      corners[2 * i] = at.x();
      corners[2 * i + 1] = at.y();
    }
    return corners;
  }
}
