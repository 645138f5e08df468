package org.u2sa.sim.performance;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Motion along or about a body axis: forward, right, down. */
public enum MotionAxis {
  /** Forward. */
  SURGE("ahead", "astern"),
  /** To the right. */
  SWAY("right", "left"),
  /** Down. */
  HEAVE("down", "up"),
  /** Right side down. */
  ROLL("rolling right", "rolling left"),
  /** Bow up. */
  PITCH("pitching up", "pitching down"),
  /** Clockwise seen from above. */
  YAW("turning right", "turning left");

  private final String positive;
  private final String negative;

  MotionAxis(String positive, String negative) {
    this.positive = positive;
    this.negative = negative;
  }

  /** Name of the direction with this sign. */
  public String name(double sign) {
    return sign > 0.0 ? positive : negative;
  }

  /** Whether it is a rotation. */
  public boolean isRotation() {
    return ordinal() >= ROLL.ordinal();
  }

  /** Velocities in the order of the axes [m/s], [rad/s]. */
  public static double[] velocities(VehicleTruth truth) {
    Point enu = truth.velocity();
    Point ned = Point.of(enu.y(), enu.x(), -enu.z());
    Point body = truth.attitude().nedFromFrd().transposed().times(ned);
    Point turn = truth.rates();
    return new double[] {body.x(), body.y(), body.z(), turn.x(), turn.y(), turn.z()};
  }
}
