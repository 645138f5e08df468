package org.u2sa.control.subsystem;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.control.ControlSystem;
import org.u2sa.device.MountingPose;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;

/**
 * Moves the joints of a subsystem to the navigation points addressed to it (thesis 3.2.3.5,
 * 3.2.3.8). In: navigation, state, actuators. Out: actuation of its joints by angle.
 *
 * <p>The joints' scales and limits are those that their actuators announce; an angle beyond them is
 * clamped. Turns of the vehicle since the navigation point was computed are compensated; its
 * displacement since then is not. Without states, points are relative to the current pose.
 */
public abstract class SubsystemControl extends ControlSystem {
  private static final double FULL_PERCENT = 100.0;

  private enum WithoutPoint {
    HOLD,
    NEUTRAL
  }

  private record Variables(
      @Variable(ifAbsentText = "HOLD")
          @Description("Without a navigation point: HOLD stays, NEUTRAL commands all angles to 0.")
          WithoutPoint withoutPoint) {}

  private final String subsystem;
  private final MountingPose mounted;
  private final Settings<Variables> tuning = settings(Variables.class);
  private final Map<String, ActuatorAnnouncement> announced = new HashMap<>(); // of the joints
  private Set<String> joints = Set.of();
  private boolean isMissingTold;

  /**
   * @param subsystem default of the variable SUBSYSTEM
   */
  protected SubsystemControl(ServiceContext context, String serviceName, String subsystem) {
    super(context, serviceName);
    this.subsystem =
        getVariable(
            VariableDeclaration.text("SUBSYSTEM")
                .ifAbsent(subsystem)
                .describedAs("Subsystem whose navigation points this service follows."));
    mounted = settings(MountingPose.class).get();
    subscribe(Channels.ACTUATORS, this::onActuator);
  }

  /** Names the joints' actuators; call it in the constructor. */
  protected final void joints(String... actuators) {
    joints = new LinkedHashSet<>(List.of(actuators));
  }

  /**
   * The joints' angles for a target.
   *
   * @param target in the axes of the subsystem's base: forward, left, down [m]
   * @return angles by actuator name [rad], without those that stay unchanged
   */
  protected abstract Map<String, Double> angles(Point target);

  /** Whether roll and pitch of the vehicle are compensated by the device itself. */
  protected boolean isLevelled() {
    return false;
  }

  @Override
  protected final String subsystem() {
    return subsystem;
  }

  @Override
  protected final boolean obeysWithoutState() {
    return true;
  }

  private void onActuator(ActuatorAnnouncement announcement) {
    if (joints.contains(announcement.actuatorName())) {
      announced.put(announcement.actuatorName(), announcement);
    }
  }

  @Override
  protected final void control(StateInformation state, Optional<NavigationPoint> point) {
    Optional<Point> target = point.flatMap(this::nedOf).map(ned -> seen(ned, state));
    if (target.isPresent()) {
      angles(target.get()).forEach(this::turn);
    } else if (tuning.get().withoutPoint() == WithoutPoint.NEUTRAL) {
      joints.forEach(joint -> turn(joint, 0.0));
    } else {
      joints.forEach(this::hold);
    }
  }

  private Point seen(Point ned, StateInformation state) {
    double roll = isLevelled() ? 0.0 : state.phi().orElse(0.0);
    double pitch = isLevelled() ? 0.0 : state.theta().orElse(0.0);
    return mounted.seen(new Attitude(roll, pitch, state.psi().orElse(0.0)).bodyOf(ned));
  }

  /** Commands a joint's angle [rad] within its limits, once the joint is announced. */
  private void turn(String joint, double angleRad) {
    Optional<ActuatorAnnouncement> actuator = actuator(joint);
    if (actuator.isEmpty()) {
      return;
    }
    double full = actuator.get().fullAngle().getAsDouble();
    double percent = FULL_PERCENT * angleRad / full;
    double within = Math.max(actuator.get().minimum(), Math.min(actuator.get().maximum(), percent));
    command(AngleCommand.of(joint, within * full / FULL_PERCENT), within);
  }

  private void hold(String joint) {
    OptionalDouble last = lastCommand(joint);
    if (last.isPresent() && actuator(joint).isPresent()) {
      turn(
          joint,
          last.getAsDouble() * actuator(joint).get().fullAngle().getAsDouble() / FULL_PERCENT);
    }
  }

  private Optional<ActuatorAnnouncement> actuator(String joint) {
    Optional<ActuatorAnnouncement> known =
        Optional.ofNullable(announced.get(joint))
            .filter(each -> each.fullAngle().isPresent() && each.fullAngle().getAsDouble() != 0.0);
    if (known.isEmpty() && !isMissingTold) {
      isMissingTold = true;
      log(LogLevelEnum.WARN, "no actuator \"" + joint + "\" has announced that it takes angles");
    }
    return known;
  }

  /** Joints stay where they are when the service ends. */
  @Override
  protected final Map<String, Double> neutral() {
    return new LinkedHashMap<>();
  }
}
