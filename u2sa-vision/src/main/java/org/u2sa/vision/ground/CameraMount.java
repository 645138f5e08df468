package org.u2sa.vision.ground;

import org.u2sa.device.MountingPose;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Mounting of a camera on its vehicle, and height above the ground.
 *
 * @param place camera position in FRD axes: forward, right, down from the reference point [m]
 * @param turn rotation from camera axes (x ahead, y right, z down) to FRD axes
 * @param groundBelowM distance of the ground below the reference point [m], positive down
 */
public record CameraMount(Point place, Rotation turn, double groundBelowM) {
  /** Creates a mount from the variables MOUNTED …, which are in BODY. */
  public static CameraMount of(MountingPose pose, double groundBelowM) {
    // BODY is left-handed: y, roll and yaw have opposite signs in FRD axes.
    return new CameraMount(
        Point.of(pose.x(), -pose.y(), pose.z()),
        Rotation.nedFromFrd(-pose.roll(), pose.pitch(), -pose.yaw()),
        groundBelowM);
  }

  /** Copy above lower ground [m]. */
  public CameraMount withGroundLower(double metres) {
    return new CameraMount(place, turn, groundBelowM + metres);
  }

  /** Camera height above level ground with the vehicle level [m]. */
  public double heightM() {
    return groundBelowM - place.z();
  }
}
