package org.u2sa.control.subsystem;

import java.util.LinkedHashMap;
import java.util.Map;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/**
 * Points a gimbal at the navigation points of its subsystem (thesis 2.2). In: navigation, state,
 * actuators. Out: actuation of its pan axis, to the left positive, and its tilt axis, up positive.
 */
public final class GimbalControl extends SubsystemControl {
  private static final double OVERHEAD_M = 1.0e-3; // closer to the pan axis a point has no bearing

  private record Variables(
      @Variable(ifAbsentText = "PAN") @Description("Actuator of the pan axis.") String panActuator,
      @Variable(ifAbsentText = "TILT") @Description("Actuator of the tilt axis.")
          String tiltActuator,
      @Variable(ifAbsentText = "false")
          @Description(
              "Whether the gimbal itself keeps its angles relative to the horizon, so that roll and pitch must not be compensated twice.")
          boolean levelled) {}

  private final Variables variables = settings(Variables.class).get();

  public GimbalControl(ServiceContext context) {
    super(context, "GimbalControl", "GIMBAL");
    joints(variables.panActuator(), variables.tiltActuator());
  }

  @Override
  protected boolean isLevelled() {
    return variables.levelled();
  }

  @Override
  protected Map<String, Double> angles(Point target) {
    double horizontal = Math.hypot(target.x(), target.y());
    double tilt = Math.atan2(-target.z(), horizontal);
    Map<String, Double> angles = new LinkedHashMap<>();
    if (horizontal >= OVERHEAD_M) {
      angles.put(variables.panActuator(), Math.atan2(target.y(), target.x()));
    }
    angles.put(variables.tiltActuator(), tilt);
    return angles;
  }
}
