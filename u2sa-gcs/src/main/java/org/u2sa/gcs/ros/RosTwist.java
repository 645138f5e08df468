package org.u2sa.gcs.ros;

import static org.u2sa.gcs.ros.RosSpelling.fields;

import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ManualDrive;

/** {@code geometry_msgs/Twist} as a manual driving command, and back. */
final class RosTwist {
  /** Topic for manual driving with ROS tools. */
  static final String TOPIC = "/cmd_vel";

  private RosTwist() {}

  /**
   * Reads a twist.
   *
   * @param operator name of the driver
   * @throws BadInputException naming a component that is not a number, or that a vehicle on the
   *     ground or water lacks
   */
  static ManualDrive drive(Map<?, ?> twist, String operator) {
    for (String none : new String[] {"linear.y", "linear.z", "angular.x", "angular.y"}) {
      if (component(twist, none) != 0.0) {
        throw new BadInputException(none + ": expected 0; only linear.x and angular.z are obeyed");
      }
    }
    return new ManualDrive()
        .operator(operator)
        .speed(component(twist, "linear.x"))
        .turnRate(component(twist, "angular.z"));
  }

  private static double component(Map<?, ?> twist, String name) {
    int dot = name.indexOf('.');
    Object vector = twist.get(name.substring(0, dot));
    Object value = vector instanceof Map<?, ?> map ? map.get(name.substring(dot + 1)) : null;
    if (value == null) {
      return 0.0; // as rosbridge fills in omitted fields
    }
    if (value instanceof Number number && Double.isFinite(number.doubleValue())) {
      return number.doubleValue();
    }
    throw new BadInputException(name + ": expected a finite number");
  }

  static Optional<Object> of(ManualDrive drive) {
    return drive.speed().isEmpty() || drive.turnRate().isEmpty()
        ? Optional.empty() // fractions of the vehicle's limits
        : Optional.of(
            fields(
                "linear",
                RosFrames.xyz(Point.of(drive.speed().getAsDouble(), 0.0, 0.0)),
                "angular",
                RosFrames.xyz(Point.of(0.0, 0.0, drive.turnRate().getAsDouble()))));
  }
}
