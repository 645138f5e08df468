package org.u2sa.vision.lens;

import java.util.Optional;
import org.u2sa.device.port.CameraFrame.Intrinsics;

/**
 * A calibrated camera geometry: pinhole model with Brown's distortion (Brown 1966; the coefficients
 * and their order are those of OpenCV and BoofCV). In normalised image coordinates, x right and y
 * down: a point (x, y) with r² = x² + y² is imaged at x (1 + k1 r² + k2 r⁴ + k3 r⁶) + 2 p1 x y + p2
 * (r² + 2 x²), and likewise for y.
 *
 * @param width image width of the calibration [px]
 * @param height image height of the calibration [px]
 * @param pinhole focal lengths and principal point [px]; 0 is the centre of the first pixel
 * @param k1 radial distortion
 * @param k2 radial distortion
 * @param p1 tangential distortion
 * @param p2 tangential distortion
 * @param k3 radial distortion
 * @param errorPx RMS reprojection error [px]; 0 if not measured
 * @param pictures number of calibration images; 0 if none
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
  private static final double WIDEST = 3.0; // tangent of the largest angle off axis considered
  private static final double STEP = 0.01;
  private static final int ITERATIONS = 12;
  private static final double SMALLEST = 1e-12;

  /** A point in normalised image coordinates (plane at depth 1, x right, y down), or a pixel. */
  public record Spot(double x, double y) {}

  /**
   * @throws IllegalArgumentException if the image is empty or a number is not finite
   */
  public LensCalibration {
    if (width < 1 || height < 1) {
      throw new IllegalArgumentException("pictures of " + width + " x " + height + " pixels");
    }
    if (!Double.isFinite(k1 + k2 + p1 + p2 + k3 + errorPx)) {
      throw new IllegalArgumentException("distortion is not finite");
    }
  }

  /** Distortion-free pinhole, as reported by simulated cameras. */
  public static LensCalibration pinhole(int width, int height, Intrinsics pinhole) {
    return new LensCalibration(width, height, pinhole, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0);
  }

  /** Approximation for a camera with only a known horizontal field of view [rad]. */
  public static LensCalibration ofView(int width, int height, double viewRad) {
    double focal = 0.5 * width / Math.tan(0.5 * viewRad);
    return pinhole(
        width, height, new Intrinsics(focal, focal, 0.5 * (width - 1), 0.5 * (height - 1)));
  }

  /**
   * Copy scaled to images of another size taken with the full sensor.
   *
   * @throws IllegalArgumentException if the aspect ratio differs, which means that the image is
   *     cropped
   */
  public LensCalibration scaledTo(int newWidth, int newHeight) {
    if (newWidth == width && newHeight == height) {
      return this;
    }
    if (Math.abs((double) newWidth * height - (double) newHeight * width) > width + height) {
      throw new IllegalArgumentException(
          String.format(
              "calibrated with pictures of %d x %d pixels: %d x %d has a different aspect ratio",
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

  /** Distorts a point in normalised coordinates. */
  public Spot distorted(double x, double y) {
    double r2 = x * x + y * y;
    double radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
    return new Spot(
        x * radial + 2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x),
        y * radial + p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y);
  }

  /** Pixel of an undistorted point in normalised coordinates. */
  public Spot pixel(double x, double y) {
    Spot seen = distorted(x, y);
    return new Spot(
        pinhole.focalX() * seen.x() + pinhole.centreX(),
        pinhole.focalY() * seen.y() + pinhole.centreY());
  }

  /**
   * Undistorted normalised coordinates of a pixel, by Newton's method; empty outside the field of
   * view, beyond {@link #reach}.
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
      double slope = 2.0 * (k1 + r2 * (2.0 * k2 + 3.0 * r2 * k3)); // of the radial factor
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

  /** Radius at depth 1 up to which the distortion is monotonic and thus unambiguous. */
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
