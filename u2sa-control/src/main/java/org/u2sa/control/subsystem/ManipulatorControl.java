package org.u2sa.control.subsystem;

import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/**
 * Moves the tip of an arm with a turning base, a shoulder and an elbow to the navigation points of
 * its subsystem (thesis 2.2). In: navigation, state, actuators. Out: actuation of the three joints.
 *
 * <p>At 0 the arm is stretched out straight ahead. Angles are positive to the left for the base, up
 * for the shoulder, and up relative to the upper arm for the elbow. Towards a target out of reach,
 * the arm stretches as far as it can.
 */
public final class ManipulatorControl extends SubsystemControl {
  private record Variables(
      @Variable(ifAbsentText = "ARM BASE")
          @Description("Actuator that turns the arm left and right.")
          String baseActuator,
      @Variable(ifAbsentText = "SHOULDER") @Description("Actuator that raises the upper arm.")
          String shoulderActuator,
      @Variable(ifAbsentText = "ELBOW") @Description("Actuator that raises the forearm.")
          String elbowActuator,
      @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 0.3)
          @Description("Length of the upper arm, from shoulder to elbow.")
          double upperArm,
      @Variable(unit = "m", min = 0.01, max = 100, ifAbsent = 0.3)
          @Description("Length of the forearm, from elbow to tip.")
          double forearm,
      @Variable(ifAbsentText = "true")
          @Description("Whether the elbow is above the line from shoulder to tip.")
          boolean elbowUp) {}

  private final Variables variables = settings(Variables.class).get();

  public ManipulatorControl(ServiceContext context) {
    super(context, "ManipulatorControl", "ARM");
    joints(variables.baseActuator(), variables.shoulderActuator(), variables.elbowActuator());
  }

  // The planar two-link arm in closed form (Craig, Introduction to Robotics, section 4.4).
  @Override
  protected Map<String, Double> angles(Point target) {
    double upper = variables.upperArm();
    double fore = variables.forearm();
    double out = Math.hypot(target.x(), target.y());
    double distance =
        Math.max(Math.abs(upper - fore), Math.min(upper + fore, Math.hypot(out, target.z())));
    double cos = (distance * distance - upper * upper - fore * fore) / (2.0 * upper * fore);
    double bend = Math.acos(Math.max(-1.0, Math.min(1.0, cos)));
    double elbow = variables.elbowUp() ? -bend : bend;
    double shoulder =
        Math.atan2(-target.z(), out)
            - Math.atan2(fore * Math.sin(elbow), upper + fore * Math.cos(elbow));
    Map<String, Double> angles = new LinkedHashMap<>();
    angles.put(variables.baseActuator(), Math.atan2(target.y(), target.x()));
    angles.put(variables.shoulderActuator(), shoulder);
    angles.put(variables.elbowActuator(), elbow);
    return angles;
  }
}
