package org.u2sa.device;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.device.port.MotorController;
import org.u2sa.device.wheel.OdometryVariables;
import org.u2sa.device.wheel.WheelOdometry;
import org.u2sa.device.wheel.WheelVariables;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.command.SpeedCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.actuator.ActuatorDescription;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * Actuator and odometry service of a differential vehicle's motor controller; one service because
 * both share a serial line (thesis 4.1.1.5). In: actuation, emergency-stop, arming-state. Out:
 * sensed-state, from the wheels' speeds; power; actuators.
 *
 * <p>Both motors are off unless both have a valid command: a partial failure of control must not
 * drive the vehicle in circles.
 */
public final class WheelMotors extends PeriodicService implements ActuatorOwner {
  private static final double STEPS_PER_S = 100.0;
  private static final double BATTERY_EVERY_S = 1.0;
  private static final double SILENT_AFTER_S = 0.5;
  private static final double FULL_PERCENT = 100.0;
  private static final Devices.Usual USUAL =
      new Devices.Usual(
          "motor controller", "CONTROLLER", "ROBOCLAW", "serial:/dev/ttyACM0?baud=115200");
  private static final String LEFT_SLEW = "LEFT SLEW";
  private static final String RIGHT_SLEW = "RIGHT SLEW";

  private final Wheel left;
  private final Wheel right;
  private final boolean leftIsSecond;
  private final double dutyPerPercent;
  private final double countsPerRad;
  private final CommandedActuators commands;
  private final WheelOdometry odometry;
  private final long stateEveryMicros;
  private final MotorController controller;
  private final DeviceReader<MotorController.Counts> reader;
  private final long goesOnMicros; // controller's time-out: motors keep running without commands
  private long turningUntilMicros = Long.MIN_VALUE; // after a takeover, until the first reading
  private long stateDueMicros;
  private double batteryDueS;

  public WheelMotors(ServiceContext context) {
    this(context, Optional.empty());
  }

  public WheelMotors(ServiceContext context, MotorController controller) {
    this(context, Optional.of(controller));
  }

  private WheelMotors(ServiceContext context, Optional<MotorController> made) {
    super(context, ServiceRole.ACTUATOR, "WheelMotors", STEPS_PER_S);
    WheelVariables variables = settings(WheelVariables.class).get();
    controller = // before the odometry's variables, which may follow from it
        Devices.open(MotorController.class, USUAL, context, getServiceName(), made);
    leftIsSecond = variables.leftIsSecond();
    dutyPerPercent = variables.fullDuty() / FULL_PERCENT;
    left = wheel(variables.leftActuator(), variables.leftReversed(), variables);
    right = wheel(variables.rightActuator(), variables.rightReversed(), variables);
    commands = new CommandedActuators(this, Set.of(left.name, right.name), this::stopNow);
    OdometryVariables wheels = settings(OdometryVariables.class).get();
    countsPerRad = wheels.countsPerTurn() / (2.0 * Math.PI);
    odometry = wheels.odometry();
    stateEveryMicros = Clock.micros(1.0 / variables.stateRate());
    registerPublisher(Channels.SENSED_STATE);
    registerPublisher(Channels.POWER);
    goesOnMicros = Clock.micros(variables.serialTimeout());
    reader = new DeviceReader<>(this, "the motor controller", controller, SILENT_AFTER_S);
  }

  private Wheel wheel(String name, boolean reversed, WheelVariables variables) {
    return new Wheel(
        name,
        reversed ? -1 : 1,
        settings(ActuatorDescription.class, name + " ").get(),
        new SlewLimit(variables.slewLimit()));
  }

  private record Wheel(String name, int sign, ActuatorDescription description, SlewLimit slew) {
    ActuatorAnnouncement announcement(String effect) {
      return description.addTo(
          new ActuatorAnnouncement()
              .actuatorName(name)
              .minimum(-FULL_PERCENT)
              .maximum(FULL_PERCENT)
              .effect(effect));
    }
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    return List.of(
        left.announcement("drives the left wheel forward"),
        right.announcement("drives the right wheel forward"));
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
    if (commands.isCommanded()) {
      turningUntilMicros = clock().micros() + goesOnMicros;
    } else {
      controller.stop(clock().micros());
    }
  }

  private void stopNow() {
    rest(clock().micros());
    controller.stop(clock().micros());
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    drive(now);
    Optional<MotorController.Counts> counts = reader.next(now);
    boolean isLost = reader.latest().isEmpty();
    if (isLost) {
      lost(now);
    }
    commands.available(isLost ? 0.0 : FULL_PERCENT);
    counts.ifPresent(news -> use(news, nowS));
    commands.step(nowS);
  }

  private void drive(long nowMicros) {
    OptionalDouble leftPercent = commands.percentage(left.name);
    OptionalDouble rightPercent = commands.percentage(right.name);
    if (leftPercent.isEmpty() || rightPercent.isEmpty()) {
      rest(nowMicros);
      controller.drive(0.0, 0.0);
      return;
    }
    if (turn()) {
      left.slew.goOnFrom(leftPercent.getAsDouble());
      right.slew.goOnFrom(rightPercent.getAsDouble());
      return;
    }
    double leftDuty = duty(left, leftPercent.getAsDouble(), nowMicros);
    double rightDuty = duty(right, rightPercent.getAsDouble(), nowMicros);
    controller.drive(leftIsSecond ? rightDuty : leftDuty, leftIsSecond ? leftDuty : rightDuty);
  }

  private double duty(Wheel wheel, double percent, long nowMicros) {
    return wheel.sign * dutyPerPercent * wheel.slew.towards(percent, nowMicros);
  }

  /** Enables the controller's speed control, if speeds are commanded and it supports that. */
  private boolean turn() {
    if (commands.command(left.name).orElse(null) instanceof SpeedCommand leftSpeed
        && commands.command(right.name).orElse(null) instanceof SpeedCommand rightSpeed) {
      double first = left.sign * leftSpeed.speed() * countsPerRad;
      double second = right.sign * rightSpeed.speed() * countsPerRad;
      return controller.turn(leftIsSecond ? second : first, leftIsSecond ? first : second);
    }
    return false;
  }

  private void rest(long nowMicros) {
    left.slew.rest(nowMicros);
    right.slew.rest(nowMicros);
  }

  private void lost(long nowMicros) {
    odometry.reset();
    if (nowMicros >= turningUntilMicros) {
      rest(nowMicros); // ramps up from 0 afterwards
    }
  }

  private void use(MotorController.Counts counts, double nowS) {
    turningUntilMicros = Long.MIN_VALUE;
    if (counts.measuredAtMicros() >= stateDueMicros) {
      stateDueMicros = counts.measuredAtMicros() + stateEveryMicros;
      publishState(counts);
    }
    if (nowS >= batteryDueS && counts.batteryV().isPresent()) {
      batteryDueS = nowS + BATTERY_EVERY_S;
      reader.mapped(() -> battery(counts)).ifPresent(each -> publish(Channels.POWER, each));
    }
  }

  private BatteryState battery(MotorController.Counts counts) {
    return new BatteryState().sensorName(getServiceName()).voltage(counts.batteryV().getAsDouble());
  }

  private void publishState(MotorController.Counts counts) {
    int leftCounts = left.sign * (leftIsSecond ? counts.second() : counts.first());
    int rightCounts = right.sign * (leftIsSecond ? counts.first() : counts.second());
    reader
        .mapped(() -> odometry.moved(counts.measuredAtMicros(), leftCounts, rightCounts))
        .flatMap(state -> state)
        .ifPresent(state -> publish(Channels.SENSED_STATE, state.sensorName(getServiceName())));
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
    state.number(LEFT_SLEW, left.slew.percent()).number(RIGHT_SLEW, right.slew.percent());
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
    state.number(LEFT_SLEW).ifPresent(left.slew::goOnFrom);
    state.number(RIGHT_SLEW).ifPresent(right.slew::goOnFrom);
  }

  @Override
  protected void releaseToSuccessor() {
    controller.leave();
  }

  @Override
  protected void release() {
    try {
      controller.close();
    } finally {
      commands.withdraw();
    }
  }
}
