package org.u2sa.world.sdf;

import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Position and attitude in a frame: SDFormat's {@code <pose>}, x y z roll pitch yaw [m, rad].
 *
 * @param at origin of the body in the frame [m]
 * @param rotation from the body's axes to the frame's
 */
record SdfPose(Point at, Rotation rotation) {
  static final SdfPose NONE = new SdfPose(Point.ORIGIN, Rotation.aboutUp(0.0));

  private static final int NUMBERS = 6;
  private static final double UPRIGHT = 1e-6;

  /** The pose given by an element's child, or {@link #NONE}. */
  static SdfPose of(XmlElement element) {
    return element.child("pose").map(SdfPose::read).orElse(NONE);
  }

  /**
   * Reads {@code <pose>}.
   *
   * @throws org.u2sa.interfaces.BadInputException if it is not six numbers
   */
  static SdfPose read(XmlElement pose) {
    double[] n = SdfNumbers.of(pose, NUMBERS);
    boolean inDegrees = pose.optionalAttribute("degrees").filter("true"::equals).isPresent();
    double unit = inDegrees ? Math.toRadians(1.0) : 1.0;
    // SDFormat turns by roll, pitch and yaw about fixed axes x, y, z: the matrix of Euler angles
    // z, y, x, whatever the names of the axes.
    return new SdfPose(
        Point.of(n[0], n[1], n[2]), Rotation.nedFromFrd(unit * n[3], unit * n[4], unit * n[5]));
  }

  /** Converts a pose relative to this one's body to this one's frame. */
  SdfPose then(SdfPose child) {
    return new SdfPose(place(child.at), rotation.times(child.rotation));
  }

  /** A point of the body in the frame. */
  Point place(Point ofBody) {
    return at.plus(rotation.times(ofBody));
  }

  /** Whether the body's z axis is vertical, either way up. */
  boolean isUpright() {
    return Math.abs(rotation.times(Point.of(0.0, 0.0, 1.0)).z()) > 1.0 - UPRIGHT;
  }

  /** Direction of the body's x axis, anticlockwise from the frame's x [rad]. */
  double yawRad() {
    Point x = rotation.times(Point.of(1.0, 0.0, 0.0));
    return Math.atan2(x.y(), x.x());
  }
}
