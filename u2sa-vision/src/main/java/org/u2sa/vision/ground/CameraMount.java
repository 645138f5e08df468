package org.u2sa.vision.ground;

import org.u2sa.device.MountingPose;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * How a camera is fixed to its vehicle, and how high that is above the ground.
 *
 * @param place of the camera in FRD axes: forward, right, down from the reference point [m]
 * @param turn of camera axes (x ahead, y right, z down) into FRD axes
 * @param groundBelowM how far below the reference point the ground is [m], positive down
 */
public record CameraMount(Point place, Rotation turn, double groundBelowM) {
  /** As the variables MOUNTED … say it, in BODY. */
  public static CameraMount of(MountingPose pose, double groundBelowM) {
    // BODY is left-handed: y, roll and yaw have the other sign in FRD axes.
    return new CameraMount(
        Point.of(pose.x(), -pose.y(), pose.z()),
        Rotation.nedFromFrd(-pose.roll(), pose.pitch(), -pose.yaw()),
        groundBelowM);
  }

  /** Height of the camera above level ground while the vehicle stands level [m]. */
  public double heightM() {
    return groundBelowM - place.z();
  }
}
