package org.u2sa.world.sdf;

import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;

/**
 * Position and attitude in a frame: SDFormat's {@code <pose>}.
 *
 * @param at origin of the body in the frame [m]
 * @param rotation from the body's axes to the frame's
 */
record SdfPose(Point at, Rotation rotation) {
  static final SdfPose NONE = new SdfPose(Point.ORIGIN, Rotation.aboutUp(0.0));

  private static final int EULER = 6;
  private static final int QUATERNION = 7;
  private static final double UPRIGHT = 1e-6;

  /** The pose given by an element's child, or {@link #NONE}. */
  static SdfPose of(XmlElement element) {
    return element.child("pose").map(SdfPose::read).orElse(NONE);
  }

  /**
   * Reads {@code <pose>}: x y z roll pitch yaw [m, rad], by {@code degrees} [deg], or by {@code
   * rotation_format} a quaternion x y z w; empty for none.
   *
   * @throws org.u2sa.interfaces.BadInputException if it is something else
   */
  static SdfPose read(XmlElement pose) {
    boolean inDegrees = pose.optionalAttribute("degrees").filter(SdfNumbers::isTrue).isPresent();
    String format = pose.optionalAttribute("rotation_format").orElse("euler_rpy");
    boolean quaternion = format.equals("quat_xyzw");
    if (!quaternion && !format.equals("euler_rpy")) {
      throw pose.error("rotation_format=\"" + format + "\": expected euler_rpy or quat_xyzw");
    }
    if (quaternion && inDegrees) {
      throw pose.error("degrees=\"true\": expected no degrees for a quaternion");
    }
    if (pose.text().isEmpty()) {
      return NONE;
    }
    double[] n = SdfNumbers.of(pose, quaternion ? QUATERNION : EULER);
    Point at = Point.of(n[0], n[1], n[2]);
    if (quaternion) {
      if (n[3] == 0.0 && n[4] == 0.0 && n[5] == 0.0 && n[6] == 0.0) {
        throw pose.error("\"" + pose.text() + "\": expected a quaternion other than 0 0 0 0");
      }
      return new SdfPose(at, Rotation.ofQuaternion(n[6], n[3], n[4], n[5]));
    }
    double unit = inDegrees ? Math.toRadians(1.0) : 1.0;
    // SDFormat turns by roll, pitch and yaw about fixed axes x, y, z: the matrix of Euler angles
    // z, y, x, whatever the names of the axes.
    return new SdfPose(at, Rotation.nedFromFrd(unit * n[3], unit * n[4], unit * n[5]));
  }

  /** Pose of the frame in the body's. */
  SdfPose inverse() {
    Rotation back = rotation.transposed();
    return new SdfPose(back.times(Point.ORIGIN.minus(at)), back);
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
