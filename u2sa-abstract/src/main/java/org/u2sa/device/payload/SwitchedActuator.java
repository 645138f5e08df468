package org.u2sa.device.payload;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.device.DeviceReader;
import org.u2sa.device.Devices;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * Actuator service of a payload with named positions: gripper, drop mechanism, launcher, brake or
 * light (thesis 2.2, 3.2.2.5). In: actuation, emergency-stop, arming-state. Out: actuators.
 *
 * <p>A command is the level of a position [%]; the nearest one counts. Its {@link SwitchKind}
 * determines the behaviour without commands. A RELEASE obeys its {@link ReleaseInterlock} only.
 */
public final class SwitchedActuator extends PeriodicService implements ActuatorOwner {
  private static final double STEPS_PER_S = 50.0;
  private static final double ALL_PERCENT = 100.0;
  private static final double TIMEOUT_S = 2.0; // without a reading from a connected output
  private static final String LEVEL = "LEVEL";

  private static final Devices.Usual USUAL =
      new Devices.Usual("output", "OUTPUT", "SYSFS", "/sys/class/pwm/pwmchip0/pwm0/duty_cycle");

  private record Variables(
      @Variable(ifAbsentText = "")
          @Description(
              "Name to which commands are addressed, unique in the system; empty: the service's name.")
          String actuatorName,
      @Variable(ifAbsentText = "PAYLOAD")
          @Description("Name of its subsystem, as used by planners.")
          String subsystem,
      @Variable
          @Description(
              "Kind of payload. Without commands, at an emergency stop and while disarmed, GRIPPER and LIGHT keep their position, BRAKE engages, and RELEASE locks behind its interlock.")
          SwitchKind kind,
      @Variable(ifAbsentText = "")
          @Description(
              "Names and levels of the positions in %, such as \"OPEN 0, CLOSED 100\". RELEASE: the first is the safe one. BRAKE: the last is the engaged one. Empty: the kind's defaults.")
          String positions,
      @Variable(unit = "s", min = 0.1, max = 60, ifAbsent = 1)
          @Description("RELEASE: time for which the release must be commanded before it fires.")
          double holdTime,
      @Variable(unit = "s", min = 0.02, max = 3600, ifAbsent = 2)
          @Description("RELEASE: maximum time for which it fires; then it locks again.")
          double fireTime) {}

  private final Variables variables;
  private final String actuatorName;
  private final SwitchPositions positions;
  private final ReleaseInterlock interlock;
  private final CommandedActuators commands;
  private final SwitchOutput output;
  private final DeviceReader<SwitchOutput.Level> reader;
  private OptionalDouble level = OptionalDouble.empty(); // set last [%]
  private boolean isRefusalTold;
  private boolean hasFired; // by the command that lasts

  public SwitchedActuator(ServiceContext context) {
    this(context, Optional.empty());
  }

  public SwitchedActuator(ServiceContext context, SwitchOutput output) {
    this(context, Optional.of(output));
  }

  private SwitchedActuator(ServiceContext context, Optional<SwitchOutput> made) {
    super(context, ServiceRole.ACTUATOR, "SwitchedActuator", STEPS_PER_S);
    variables = settings(Variables.class).get();
    actuatorName = variables.actuatorName().isEmpty() ? getServiceName() : variables.actuatorName();
    String stated = variables.positions();
    positions = new SwitchPositions(stated.isEmpty() ? variables.kind().positions() : stated);
    interlock = new ReleaseInterlock(variables.holdTime(), variables.fireTime());
    commands = new CommandedActuators(this, Set.of(actuatorName), this::rest);
    output = Devices.open(SwitchOutput.class, USUAL, context, getServiceName(), made);
    reader = new DeviceReader<>(this, "the output", output, TIMEOUT_S);
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
    if (!commands.isCommanded()) {
      rest();
    }
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    ActuatorAnnouncement announcement =
        new ActuatorAnnouncement()
            .actuatorName(actuatorName)
            .subsystem(variables.subsystem())
            .minimum(0.0)
            .maximum(ALL_PERCENT)
            .effect(positions.toString());
    level.ifPresent(announcement::percentage);
    return List.of(announcement);
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    OptionalDouble commanded = commands.percentage(actuatorName);
    if (variables.kind() == SwitchKind.RELEASE) {
      guard(commanded, now);
    } else if (commanded.isPresent()) {
      set(positions.nearest(commanded.getAsDouble()));
    } else {
      rest();
    }
    reader.next(now);
    commands.available(output.isConnected() ? ALL_PERCENT : 0.0);
    commands.step(nowS);
  }

  private void guard(OptionalDouble commanded, long nowMicros) {
    double wanted = commanded.isPresent() ? positions.nearest(commanded.getAsDouble()) : 0.0;
    ReleaseInterlock.Wanted kind =
        commanded.isEmpty()
            ? ReleaseInterlock.Wanted.NOTHING
            : wanted == positions.first()
                ? ReleaseInterlock.Wanted.SAFE
                : ReleaseInterlock.Wanted.RELEASE;
    boolean mayFire = commands.isArmed() && commands.mayMove() && output.isConnected();
    boolean fires = interlock.fires(kind, mayFire, nowMicros);
    set(fires ? wanted : positions.first());
    boolean isReleasing = kind == ReleaseInterlock.Wanted.RELEASE;
    hasFired =
        isReleasing && mayFire && (hasFired || fires); // FIRE TIME may end before the command
    boolean isRefused = isReleasing && !fires && interlock.isLocked() && !hasFired;
    if (isRefused && !isRefusalTold) {
      log(
          LogLevelEnum.WARN,
          mayFire
              ? "stays locked: command the safe position first, then the release"
              : "stays locked: not armed, or its output is lost");
    }
    isRefusalTold = isRefused;
  }

  /** Engages a brake and locks a release; a gripper or light stays where it is. */
  private void rest() {
    if (variables.kind() == SwitchKind.BRAKE) {
      set(positions.last());
    } else if (variables.kind() == SwitchKind.RELEASE) {
      interlock.lock();
      set(positions.first());
    }
  }

  private void set(double percent) {
    output.set(percent);
    if (level.isEmpty() || level.getAsDouble() != percent) {
      level = OptionalDouble.of(percent);
      log(positions.name(percent));
      commands.hasTaken(actuatorName, percent);
    }
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
    level.ifPresent(percent -> state.number(LEVEL, percent));
  }

  /** The interlock starts locked, so that no swap releases anything. */
  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
    if (variables.kind() != SwitchKind.RELEASE) {
      state.number(LEVEL).ifPresent(percent -> set(positions.nearest(percent)));
    }
  }

  @Override
  protected void releaseToSuccessor() {
    output.leave();
  }

  @Override
  protected void release() {
    rest();
    output.read(clock().micros());
    commands.withdraw();
    output.close();
  }
}
