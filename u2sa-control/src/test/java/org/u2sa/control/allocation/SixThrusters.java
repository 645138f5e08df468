package org.u2sa.control.allocation;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

/** Announcements of an underwater vehicle: four vectored thrusters in the plane, two vertical. */
final class SixThrusters {
  static final double FORWARD_N = 40.0;
  static final double REVERSE_N = 30.0;
  private static final double HALF = Math.sqrt(0.5);

  private SixThrusters() {}

  static List<ActuatorAnnouncement> announcements() {
    List<ActuatorAnnouncement> all = new ArrayList<>();
    all.add(thruster("T1", 0.16, 0.11, 0.0, HALF, -HALF, 0.0)); // front right, pushes left
    all.add(thruster("T2", 0.16, -0.11, 0.0, HALF, HALF, 0.0));
    all.add(thruster("T3", -0.16, 0.11, 0.0, HALF, HALF, 0.0));
    all.add(thruster("T4", -0.16, -0.11, 0.0, HALF, -HALF, 0.0));
    all.add(thruster("T5", 0.0, 0.11, 0.0, 0.0, 0.0, 1.0));
    all.add(thruster("T6", 0.0, -0.11, 0.0, 0.0, 0.0, 1.0));
    return all;
  }

  static List<Effector> effectors() {
    List<Effector> effectors = new ArrayList<>();
    announcements().forEach(each -> Effector.of(each).ifPresent(effectors::add));
    return effectors;
  }

  private static ActuatorAnnouncement thruster(
      String name, double x, double y, double z, double fx, double fy, double fz) {
    return new ActuatorAnnouncement()
        .actuatorName(name)
        .minimum(-100.0)
        .maximum(100.0)
        .force(Point.of(FORWARD_N * fx, FORWARD_N * fy, FORWARD_N * fz))
        .moment(moment(x, y, z, FORWARD_N * fx, FORWARD_N * fy, FORWARD_N * fz))
        .reverseForce(Point.of(-REVERSE_N * fx, -REVERSE_N * fy, -REVERSE_N * fz))
        .reverseMoment(moment(x, y, z, -REVERSE_N * fx, -REVERSE_N * fy, -REVERSE_N * fz))
        .exponent(2.0)
        .renewal(0.25);
  }

  private static Point moment(double x, double y, double z, double fx, double fy, double fz) {
    return Point.of(y * fz - z * fy, z * fx - x * fz, x * fy - y * fx);
  }
}
