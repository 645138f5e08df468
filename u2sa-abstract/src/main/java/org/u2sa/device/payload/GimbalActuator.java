package org.u2sa.device.payload;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.device.DeviceReader;
import org.u2sa.device.Devices;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * Actuator service of a gimbal with its own controller: two actuators, its pan and its tilt axis
 * (thesis 2.2, 3.2.2.5). In: actuation, emergency-stop, arming-state. Out: actuators.
 */
public final class GimbalActuator extends PeriodicService implements ActuatorOwner {
  private static final double STEPS_PER_S = 50.0;
  private static final double ALL_PERCENT = 100.0;
  private static final double TIMEOUT_S = 2.0; // without a report of a connected gimbal

  private static final Devices.Usual USUAL =
      new Devices.Usual("gimbal", "GIMBAL", "MAVLINK", "serial:/dev/ttyACM0?baud=115200");

  private record Variables(
      @Variable(ifAbsentText = "GIMBAL")
          @Description("Name of the subsystem that it moves, as used by planners.")
          String subsystem,
      @Variable(ifAbsentText = "PAN") @Description("Actuator name of the pan axis.")
          String panActuator,
      @Variable(ifAbsentText = "TILT") @Description("Actuator name of the tilt axis.")
          String tiltActuator,
      @Variable(unit = "rad", min = -2.0 * Math.PI, max = 0, ifAbsent = -Math.PI)
          @Description("Rightmost pan angle.")
          double minimumPan,
      @Variable(unit = "rad", min = 0, max = 2.0 * Math.PI, ifAbsent = Math.PI)
          @Description("Leftmost pan angle.")
          double maximumPan,
      @Variable(unit = "rad", min = -Math.PI, max = 0, ifAbsent = -Math.PI / 2.0)
          @Description("Lowest tilt angle.")
          double minimumTilt,
      @Variable(unit = "rad", min = 0, max = Math.PI, ifAbsent = Math.PI / 6.0)
          @Description("Highest tilt angle.")
          double maximumTilt,
      @Variable(unit = "rad/s", min = 0.01, max = 100, ifAbsent = 1.5)
          @Description("Maximum rate of either axis.")
          double rateLimit,
      @Variable(ifAbsentText = "HOLD")
          @Description(
              "Behaviour without commands, at an emergency stop and while disarmed: HOLD keeps the angles, NEUTRAL points straight ahead.")
          WithoutCommands withoutCommands) {}

  private final Variables variables;
  private final GimbalAxis pan;
  private final GimbalAxis tilt;
  private final CommandedActuators commands;
  private final Gimbal gimbal;
  private final DeviceReader<Gimbal.Pointing> reader;

  public GimbalActuator(ServiceContext context) {
    this(context, Optional.empty());
  }

  public GimbalActuator(ServiceContext context, Gimbal gimbal) {
    this(context, Optional.of(gimbal));
  }

  private GimbalActuator(ServiceContext context, Optional<Gimbal> made) {
    super(context, ServiceRole.ACTUATOR, "GimbalActuator", STEPS_PER_S);
    gimbal = Devices.open(Gimbal.class, USUAL, context, getServiceName(), made);
    variables = settings(Variables.class).get(); // after the device, which may know the limits
    pan =
        new GimbalAxis(
            variables.panActuator(),
            variables.minimumPan(),
            variables.maximumPan(),
            variables.rateLimit());
    tilt =
        new GimbalAxis(
            variables.tiltActuator(),
            variables.minimumTilt(),
            variables.maximumTilt(),
            variables.rateLimit());
    commands = new CommandedActuators(this, Set.of(pan.name(), tilt.name()), () -> {});
    reader = new DeviceReader<>(this, "the gimbal", gimbal, TIMEOUT_S);
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    return List.of(
        pan.announcement(variables.subsystem(), "turns the gimbal left by %.1f deg at 100 %%"),
        tilt.announcement(variables.subsystem(), "turns the gimbal up by %.1f deg at 100 %%"));
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    WithoutCommands rest = variables.withoutCommands();
    gimbal.point(
        pan.step(commands.percentage(pan.name()), rest, now),
        tilt.step(commands.percentage(tilt.name()), rest, now));
    reader.next(now);
    commands.available(gimbal.isConnected() ? ALL_PERCENT : 0.0);
    commands.step(nowS);
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
    state.number(pan.name(), pan.percent()).number(tilt.name(), tilt.percent());
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
    state.number(pan.name()).ifPresent(pan::goOnFrom);
    state.number(tilt.name()).ifPresent(tilt::goOnFrom);
  }

  @Override
  protected void releaseToSuccessor() {
    gimbal.leave();
  }

  /** The gimbal holds its last angles. */
  @Override
  protected void release() {
    commands.withdraw();
    gimbal.close();
  }
}
