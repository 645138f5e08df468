package org.u2sa.vision.lens;

import java.util.Optional;
import org.u2sa.device.CameraFrame.Intrinsics;

/**
 * A camera's geometry as a calibration measured it: a pinhole with Brown's distortion (Brown 1966;
 * the coefficients and their order are those of OpenCV and BoofCV). Along the optical axes x right,
 * y down, by depth: a point (x, y) at r² = x² + y² is seen at x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1
 * x y + p2 (r² + 2 x²), and alike for y.
 *
 * @param width pixels of a row of the pictures it was measured with
 * @param height their rows
 * @param pinhole focal lengths and centre [pixels]; 0 is the middle of the first pixel
 * @param k1 radial distortion
 * @param k2 radial distortion
 * @param p1 tangential distortion
 * @param p2 tangential distortion
 * @param k3 radial distortion
 * @param errorPx root of the mean square distance between measured and computed corners [pixels]; 0
 *     if nothing was measured
 * @param pictures how many it was measured with; 0 if none
 */
public record LensCalibration(
    int width,
    int height,
    Intrinsics pinhole,
    double k1,
    double k2,
    double p1,
    double p2,
    double k3,
    double errorPx,
    int pictures) {
  private static final double WIDEST = 3.0; // tan of the largest angle from the axis looked at
  private static final double STEP = 0.01;
  private static final int ITERATIONS = 12;
  private static final double SMALLEST = 1e-12;

  /** A place on the plane at depth 1: x right, y down, by depth; or a pixel. */
  public record Spot(double x, double y) {}

  /**
   * @throws IllegalArgumentException if there are no pixels or a number is not finite
   */
  public LensCalibration {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException("pictures of " + width + " x " + height + " pixels");
    }
    if (!Double.isFinite(k1 + k2 + p1 + p2 + k3 + errorPx)) {
      throw new IllegalArgumentException("distortion is not finite");
    }
  }

  /** A pinhole without distortion, as a simulated camera states it. */
  public static LensCalibration pinhole(int width, int height, Intrinsics pinhole) {
    return new LensCalibration(width, height, pinhole, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0);
  }

  /** A guess for a camera of which only the angle of view from left to right is known [rad]. */
  public static LensCalibration ofView(int width, int height, double viewRad) {
    double focal = 0.5 * width / Math.tan(0.5 * viewRad);
    return pinhole(
        width, height, new Intrinsics(focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)));
  }

  /**
   * The same lens with pictures of another size, taken by the whole sensor.
   *
   * @throws IllegalArgumentException if their shape is another: then it is not the whole sensor
   */
  public LensCalibration scaledTo(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) {
      return this;
    }
    if (Math.abs((double) newWidth * height - (double) newHeight * width) > width + height) {
      throw new IllegalArgumentException(
          String.format(
              "calibrated with pictures of %d x %d pixels: %d x %d have another shape",
              width, height, newWidth, newHeight));
    }
    double by = (double) newWidth / width;
    Intrinsics scaled =
        new Intrinsics(
            by * pinhole.focalX(),
            by * pinhole.focalY(),
            by * (pinhole.centreX() + 0.5) - 0.5,
            by * (pinhole.centreY() + 0.5) - 0.5);
    return new LensCalibration(
        newWidth, newHeight, scaled, k1, k2, p1, p2, k3, errorPx * by, pictures);
  }

  /** Where a place at depth 1 is seen through the lens, still at depth 1. */
  public Spot distorted(double x, double y) {
    double r2 = x * x + y * y;
    double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    return new Spot(
        x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
        y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y);
  }

  /** The pixel at which a place at depth 1 is seen. */
  public Spot pixel(double x, double y) {
    Spot seen = distorted(x, y);
    return new Spot(
        pinhole.focalX() * seen.x() + pinhole.centreX(),
        pinhole.focalY() * seen.y() + pinhole.centreY());
  }

  /**
   * The place at depth 1 that is seen at a pixel, by Newton's method; empty where the lens shows
   * nothing: beyond {@link #reach}.
   */
  public Optional<Spot> place(double column, double row) {
    double wantedX = (column - pinhole.centreX()) / pinhole.focalX();
    double wantedY = (row - pinhole.centreY()) / pinhole.focalY();
    double x = wantedX;
    double y = wantedY;
    for (int i = 0; i < ITERATIONS; i++) {
      Spot seen = distorted(x, y);
      double offX = seen.x() - wantedX;
      double offY = seen.y() - wantedY;
      if (Math.abs(offX) + Math.abs(offY) < SMALLEST) {
        break;
      }
      double r2 = x * x + y * y;
      double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
      double slope = 2.0 * (k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3)); // of radial by x²/2 or y²/2
      double xx = radial + x * x * slope + 2.0 * p1 * y + 6.0 * p2 * x;
      double xy = x * y * slope + 2.0 * p1 * x + 2.0 * p2 * y;
      double yy = radial + y * y * slope + 6.0 * p1 * y + 2.0 * p2 * x;
      double determinant = xx * yy - xy * xy;
      if (!(Math.abs(determinant) > SMALLEST)) {
        return Optional.empty();
      }
      x -= (yy * offX - xy * offY) / determinant;
      y -= (xx * offY - xy * offX) / determinant;
    }
    Spot seen = distorted(x, y);
    boolean isFound =
        Math.hypot(seen.x() - wantedX, seen.y() - wantedY) < 1e-6
            && x * x + y * y <= reach() * reach();
    return isFound ? Optional.of(new Spot(x, y)) : Optional.empty();
  }

  /**
   * How far from the axis, at depth 1, the lens still shows things in order: beyond, the polynomial
   * turns back and would show far things a second time.
   */
  public double reach() {
    double last = 0.0;
    for (double r = STEP; r <= WIDEST; r += STEP) {
      double r2 = r * r;
      double seen = r * (1.0 + r2 * (k1 + r2 * (k2 + r2 * k3)));
      if (seen <= last) {
        return r - STEP;
      }
      last = seen;
    }
    return WIDEST;
  }
}
