package org.u2sa.sim.camera;

import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.sim.motion.Arguments;

/**
 * Optics and mounting of a colour camera. Images follow the pinhole model of {@link #intrinsics}
 * unless {@code k1} or {@code k2} is set.
 *
 * @param rateHz frames per second
 * @param width image width [px]
 * @param height image height [px]
 * @param viewRad horizontal field of view without distortion [rad]
 * @param k1 radial distortion: a point at radius r (in focal lengths) appears at r (1 + k1 r² + k2
 *     r⁴) (Brown 1966)
 * @param k2 see k1
 * @param exposureS exposure time of each row [s]
 * @param readoutS rolling-shutter readout time, first row to last [s]
 * @param sigma noise standard deviation of a mid-grey pixel, relative to white
 * @param blurPixels blur radius [px]: 0 sharp, 1 soft
 * @param forwardM position ahead of the vehicle's reference point [m]
 * @param leftM position left of it [m]
 * @param upM height above it [m]; negative below, as on a submarine
 * @param downRad downward tilt of the optical axis [rad]
 */
public record ColourLens(
    double rateHz,
    int width,
    int height,
    double viewRad,
    double k1,
    double k2,
    double exposureS,
    double readoutS,
    double sigma,
    double blurPixels,
    double forwardM,
    double leftM,
    double upM,
    double downRad) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public ColourLens {
    Arguments.requireInside("width", width, 2.0, 10_000.0);
    Arguments.requireInside("height", height, 2.0, 10_000.0);
    Arguments.requireInside("angle of view", viewRad, 0.01, 3.0);
    Arguments.requireInside("distortion k1", k1, -0.5, 0.5);
    Arguments.requireInside("distortion k2", k2, -0.5, 0.5);
    Arguments.requireInside("exposure", exposureS, 0.0, 1.0);
    Arguments.requireInside("readout", readoutS, 0.0, 1.0);
    Arguments.requireInside("noise of a pixel", sigma, 0.0, 1.0);
    Arguments.requireInside("blur", blurPixels, 0.0, 3.0);
    Arguments.requireInside("camera forward", forwardM, -100.0, 100.0);
    Arguments.requireInside("camera left", leftM, -100.0, 100.0);
    Arguments.requireInside("camera up", upM, -100.0, 1000.0);
    Arguments.requireInside("camera down", downRad, -1.57, 1.57);
  }

  /**
   * A wide-angle 640 × 480 webcam on a mast: 100° field of view, 1.1 m above the driven axle,
   * tilted down 22°.
   */
  public static ColourLens mast() {
    return new ColourLens(
        10.0,
        640,
        480,
        Math.toRadians(100.0),
        0.0,
        0.0,
        0.004,
        0.025,
        0.012,
        0.6,
        0.1,
        0.0,
        1.1,
        Math.toRadians(22.0));
  }

  /** Copy with a different frame rate. */
  public ColourLens rate(double newRateHz) {
    return new ColourLens(
        newRateHz,
        width,
        height,
        viewRad,
        k1,
        k2,
        exposureS,
        readoutS,
        sigma,
        blurPixels,
        forwardM,
        leftM,
        upM,
        downRad);
  }

  /** Intrinsics with square pixels and a centred principal point. */
  public Intrinsics intrinsics() {
    double focal = 0.5 * width / StrictMath.tan(0.5 * viewRad);
    return new Intrinsics(focal, focal, 0.5 * (width - 1), 0.5 * (height - 1));
  }
}
