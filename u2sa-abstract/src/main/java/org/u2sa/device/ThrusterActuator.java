package org.u2sa.device;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.u2sa.device.port.Thruster;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.actuator.ActuatorDescription;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * Actuator service of one thruster; a boat may have two, an underwater vehicle six (thesis
 * 3.2.2.5). In: actuation, emergency-stop, arming-state. Out: actuators, its announcement with
 * position and direction (thesis 5.1); power, if the thruster measures its battery.
 */
public final class ThrusterActuator extends PeriodicService implements ActuatorOwner {
  private static final double STEPS_PER_S = 50.0;
  private static final double BATTERY_EVERY_S = 1.0;
  private static final double SURELY_TURNING_PERCENT = 20.0; // above any start threshold
  private static final double STANDING_RPM = 10.0;
  private static final double STALL_PAUSE_S = 10.0; // before control may try again
  private static final double THRUST_EXPONENT = 2.0; // T ~ n|n| (Fossen 2011, eq. 9.9)
  private static final double ALL_PERCENT = 100.0;
  private static final String SLEW = "SLEW";
  private static final String STALL_TOLD = "STALL TOLD";
  private static final String STALLED_UNTIL = "STALLED UNTIL";

  private static final Devices.Usual USUAL =
      new Devices.Usual("thruster", "THRUSTER", "VESC", "serial:/dev/ttyACM0?baud=115200");

  private final ThrusterVariables variables;
  private final MountingPose mounted;
  private final String actuatorName;
  private final double sign;
  private final CommandedActuators commands;
  private final SlewLimit slew;
  private final Thruster thruster;
  private final DeviceReader<Thruster.Turning> reader;
  private double batteryDueS;
  private double stalledSinceS = Double.NaN;
  private boolean isStallTold;
  private double stalledUntilS = Double.POSITIVE_INFINITY;

  public ThrusterActuator(ServiceContext context) {
    this(context, Optional.empty());
  }

  public ThrusterActuator(ServiceContext context, Thruster thruster) {
    this(context, Optional.of(thruster));
  }

  private ThrusterActuator(ServiceContext context, Optional<Thruster> made) {
    super(context, ServiceRole.ACTUATOR, "ThrusterActuator", STEPS_PER_S);
    variables = settings(ThrusterVariables.class).get();
    mounted = settings(MountingPose.class).get();
    actuatorName = variables.actuatorName().isEmpty() ? getServiceName() : variables.actuatorName();
    sign = variables.reversed() ? -1.0 : 1.0;
    commands = new CommandedActuators(this, Set.of(actuatorName), this::stopNow);
    slew = new SlewLimit(variables.slewLimit());
    registerPublisher(Channels.POWER);
    thruster = Devices.open(Thruster.class, USUAL, context, getServiceName(), made);
    reader = new DeviceReader<>(this, "the thruster", thruster, variables.timeout());
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
    if (!commands.isCommanded()) {
      thruster.stop(clock().micros());
    }
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    Point place = rightHanded(Point.of(mounted.x(), mounted.y(), mounted.z()));
    Point push = rightHanded(mounted.turn().toBody(Point.of(1.0, 0.0, 0.0))).minus(place);
    ActuatorAnnouncement announcement =
        new ActuatorAnnouncement()
            .actuatorName(actuatorName)
            .minimum(variables.minimum())
            .maximum(variables.maximum())
            .deadband(variables.deadband())
            .rateLimit(variables.slewLimit())
            .effect(String.format(Locale.ROOT, "pushes along %s at %s m", text(push), text(place)));
    double ahead = variables.fullThrust();
    if (ahead > 0.0) {
      double astern = variables.reverseThrust() > 0.0 ? variables.reverseThrust() : ahead;
      ActuatorDescription.addThrust(announcement, place, push, ahead, astern)
          .exponent(THRUST_EXPONENT)
          .commandTypes(List.of("ForceCommand"));
      addTorque(announcement, push, astern / ahead);
    }
    return List.of(announcement);
  }

  /** Adds the torque of the propeller, which grows as its thrust does. */
  private void addTorque(ActuatorAnnouncement announcement, Point push, double reverseShare) {
    double torque = variables.fullTorque();
    announcement.moment().ifPresent(moment -> announcement.moment(moment.plus(push.times(torque))));
    announcement
        .reverseMoment()
        .ifPresent(
            moment -> announcement.reverseMoment(moment.minus(push.times(torque * reverseShare))));
  }

  /** Converts BODY (forward, left, down) to the announcement's forward, right, down. */
  private static Point rightHanded(Point body) {
    return Point.of(body.x(), -body.y(), body.z());
  }

  private static String text(Point point) {
    return String.format(
        Locale.ROOT, "(%.3f, %.3f, %.3f)", point.x(), point.y() + 0.0, point.z() + 0.0);
  }

  private void stopNow() {
    slew.rest(clock().micros());
    thruster.stop(clock().micros());
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    double percent = wanted(now);
    thruster.thrust(sign * percent);
    Optional<Thruster.Turning> news = reader.next(now);
    if (!thruster.isConnected()) {
      slew.rest(now); // ramps up from 0 afterwards
    }
    news.ifPresent(turning -> use(turning, percent, nowS));
    if (nowS >= stalledUntilS) {
      offerAgain();
    }
    boolean isStalled = stalledUntilS < Double.POSITIVE_INFINITY;
    commands.available(thruster.isConnected() && !isStalled ? ALL_PERCENT : 0.0);
    commands.step(nowS);
  }

  private double wanted(long nowMicros) {
    OptionalDouble commanded = commands.percentage(actuatorName);
    if (commanded.isEmpty()) {
      slew.rest(nowMicros);
      return 0.0;
    }
    double percent = slew.towards(commanded.getAsDouble(), nowMicros);
    return Math.abs(percent) < variables.deadband() ? 0.0 : percent;
  }

  private void use(Thruster.Turning turning, double percent, double nowS) {
    watchForStall(turning.rpm(), percent, nowS);
    if (nowS >= batteryDueS && turning.batteryV().isPresent()) {
      batteryDueS = nowS + BATTERY_EVERY_S;
      reader.mapped(() -> battery(turning)).ifPresent(each -> publish(Channels.POWER, each));
    }
  }

  private BatteryState battery(Thruster.Turning turning) {
    BatteryState battery =
        new BatteryState().sensorName(getServiceName()).voltage(turning.batteryV().getAsDouble());
    turning.currentA().ifPresent(battery::current);
    return battery;
  }

  /** Detects a stalled propeller, for example caught in weeds or with a broken motor. */
  private void watchForStall(OptionalDouble rpm, double percent, double nowS) {
    boolean stands = rpm.isPresent() && Math.abs(rpm.getAsDouble()) < STANDING_RPM;
    if (!stands || Math.abs(percent) < SURELY_TURNING_PERCENT) {
      stalledSinceS = Double.NaN;
      if (isStallTold && rpm.isPresent() && !stands) {
        isStallTold = false;
        log("the thruster turns again");
        offerAgain();
      }
      return;
    }
    stalledSinceS = Double.isNaN(stalledSinceS) ? nowS : stalledSinceS;
    if (nowS - stalledSinceS >= variables.timeout() && stalledUntilS > nowS + STALL_PAUSE_S) {
      stalledUntilS = nowS + STALL_PAUSE_S;
    }
    if (nowS - stalledSinceS >= variables.timeout() && !isStallTold) {
      isStallTold = true;
      trouble(
          String.format(
              Locale.ROOT, "the thruster does not turn at a command of %.0f %%", percent));
    }
  }

  private void offerAgain() {
    stalledUntilS = Double.POSITIVE_INFINITY;
    stalledSinceS = Double.NaN;
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
    state.number(SLEW, slew.percent()).flag(STALL_TOLD, isStallTold);
    if (stalledUntilS < Double.POSITIVE_INFINITY) {
      state.number(STALLED_UNTIL, stalledUntilS);
    }
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
    state.number(SLEW).ifPresent(slew::goOnFrom);
    isStallTold = state.flag(STALL_TOLD);
    stalledUntilS = state.number(STALLED_UNTIL).orElse(Double.POSITIVE_INFINITY);
  }

  @Override
  protected void releaseToSuccessor() {
    thruster.leave();
  }

  @Override
  protected void release() {
    commands.withdraw();
    thruster.close();
  }
}
