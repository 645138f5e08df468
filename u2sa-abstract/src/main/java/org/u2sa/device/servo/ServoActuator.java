package org.u2sa.device.servo;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.device.DeviceReader;
import org.u2sa.device.Devices;
import org.u2sa.device.SlewLimit;
import org.u2sa.device.payload.WithoutCommands;
import org.u2sa.device.port.Servo;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.actuator.ActuatorDescription;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * Actuator service of one servo, such as that of an elevator, a rudder or a gimbal's axis (thesis
 * 3.2.2.5). In: actuation, emergency-stop, arming-state. Out: actuators, its announcement.
 *
 * <p>Without commands, and at an emergency stop, it goes to its neutral angle, or holds its angle
 * with WITHOUT COMMANDS HOLD. It takes percentages and angles from the neutral one.
 */
public final class ServoActuator extends PeriodicService implements ActuatorOwner {
  private static final double STEPS_PER_S = 50.0;
  private static final double FULL_PERCENT = 100.0;
  private static final double TIMEOUT_S = 1.0; // without a reading from a connected servo
  private static final String SLEW = "SLEW";

  private static final Devices.Usual USUAL =
      new Devices.Usual("servo", "SERVO", "MAESTRO", "serial:/dev/ttyACM0?baud=115200");

  private record Variables(
      @Variable(ifAbsentText = "")
          @Description(
              "Name to which commands are addressed, unique in the system; empty: the service's name.")
          String actuatorName,
      @Variable(ifAbsentText = "VEHICLE")
          @Description("Subsystem that it moves, such as GIMBAL or ARM, as named by planners.")
          String subsystem,
      @Variable(ifAbsentText = "false")
          @Description("Whether a positive command turns it backwards.")
          boolean reversed,
      @Variable(unit = "%", min = -100, max = 0, ifAbsent = -100)
          @Description(
              "Minimum command; 0 for a servo that moves one way only, such as a flap servo.")
          double minimum,
      @Variable(unit = "rad", min = 0.01, max = 2.0 * Math.PI, ifAbsent = Math.PI / 6.0)
          @Description("Angle by which a command of 100 % turns it from the neutral angle.")
          double travel,
      @Variable(unit = "rad", min = -Math.PI, max = Math.PI, ifAbsent = 0)
          @Description("Angle without commands: the trim.")
          double neutralAngle,
      @Variable(unit = "rad", min = -2.0 * Math.PI, max = 0, ifAbsent = -2.0 * Math.PI)
          @Description("Smallest angle that its linkage allows.")
          double minimumAngle,
      @Variable(unit = "rad", min = 0, max = 2.0 * Math.PI, ifAbsent = 2.0 * Math.PI)
          @Description("Largest angle that its linkage allows.")
          double maximumAngle,
      @Variable(unit = "rad/s", min = 0.01, max = 1_000, ifAbsent = 10)
          @Description("Maximum rate, also on the way to the neutral angle.")
          double rateLimit,
      @Variable(ifAbsentText = "NEUTRAL")
          @Description(
              "Behaviour without commands, at an emergency stop and while disarmed: NEUTRAL moves to the neutral angle, HOLD keeps the angle, as recommended for the joints of an arm.")
          WithoutCommands withoutCommands,
      @Variable(ifAbsentText = "")
          @Description(
              "Force and moment on the vehicle at full command, as of a rudder: \"wrench X Y Z K M N\" along and about the forward, right and down axes, in N and N m; empty: no effect is announced.")
          String effect,
      @Variable(unit = "m/s", min = 0, max = 1000, ifAbsent = 0)
          @Description(
              "Speed through air or water at which the effect holds; it scales with speed squared. 0: independent of speed.")
          double effectSpeed) {
    Variables {
      ActuatorDescription.addEffect(new ActuatorAnnouncement(), effect, 0.0); // refuses a bad one
    }
  }

  private final Variables variables;
  private final String actuatorName;
  private final CommandedActuators commands;
  private final SlewLimit slew;
  private final Servo servo;
  private final DeviceReader<Servo.Position> reader;

  public ServoActuator(ServiceContext context) {
    this(context, Optional.empty());
  }

  public ServoActuator(ServiceContext context, Servo servo) {
    this(context, Optional.of(servo));
  }

  private ServoActuator(ServiceContext context, Optional<Servo> made) {
    super(context, ServiceRole.ACTUATOR, "ServoActuator", STEPS_PER_S);
    servo = Devices.open(Servo.class, USUAL, context, getServiceName(), made);
    variables = settings(Variables.class).get(); // after the device, which may know the travel
    actuatorName = variables.actuatorName().isEmpty() ? getServiceName() : variables.actuatorName();
    commands = new CommandedActuators(this, Set.of(actuatorName), () -> {});
    slew = new SlewLimit(percentPerS());
    reader = new DeviceReader<>(this, "the servo", servo, TIMEOUT_S);
  }

  private double percentPerS() {
    return FULL_PERCENT * variables.rateLimit() / variables.travel();
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    ActuatorAnnouncement announcement =
        new ActuatorAnnouncement()
            .actuatorName(actuatorName)
            .subsystem(variables.subsystem())
            .fullAngle(variables.travel())
            .commandTypes(List.of("AngleCommand"))
            .minimum(variables.minimum())
            .maximum(FULL_PERCENT)
            .rateLimit(percentPerS())
            .effect(
                String.format(
                    Locale.ROOT,
                    "turns by %.1f deg at 100 %%",
                    Math.toDegrees(variables.travel())));
    return List.of(
        ActuatorDescription.addEffect(announcement, variables.effect(), variables.effectSpeed()));
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    OptionalDouble commanded = commands.percentage(actuatorName);
    servo.turn(angleRad(slew.towards(commanded.orElse(resting()), now)));
    reader.next(now);
    commands.available(servo.isConnected() ? FULL_PERCENT : 0.0);
    commands.step(nowS);
  }

  private double resting() {
    return variables.withoutCommands() == WithoutCommands.HOLD ? slew.percent() : 0.0;
  }

  private double angleRad(double percent) {
    double sign = variables.reversed() ? -1.0 : 1.0;
    double angle = variables.neutralAngle() + sign * variables.travel() * percent / FULL_PERCENT;
    return Math.max(variables.minimumAngle(), Math.min(variables.maximumAngle(), angle));
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
    state.number(SLEW, slew.percent());
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
    state.number(SLEW).ifPresent(slew::goOnFrom);
  }

  @Override
  protected void releaseToSuccessor() {
    servo.leave();
  }

  @Override
  protected void release() {
    commands.withdraw();
    servo.turn(angleRad(resting()));
    servo.read(clock().micros());
    servo.close();
  }
}
