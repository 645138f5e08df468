package org.u2sa.drivers.ioio;

import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.drivers.motor.PulseOutput;
import org.u2sa.drivers.rc.RcSwitch;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.actuator.ActuatorDescription;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;

/**
 * Connects a vehicle through an IOIO board (thesis 4.6.2.1): GPS and compass on UARTs, motors on
 * PWM pins, radio switch, battery and status LED. In: actuation, emergency-stop, arming-state. Out:
 * sensed-state, power, actuators.
 *
 * <p>Motors are neutral without a current command, during an emergency stop, while disarmed, and
 * while the radio switch is not on automatic. Without a connection the board outputs no pulses, and
 * the actuators are announced as lost. No call blocks on the board.
 */
public final class IoioService extends ProprioceptiveSensor implements ActuatorOwner {
  private static final double STEPS_PER_S = 100.0;
  private static final double BATTERY_EVERY_S = 1.0;
  private static final double GREETING_EVERY_S = 1.0; // a served board drops a silent host
  private static final int MAX_PULSES_A_STEP = 100; // bounds a step under a flood of pulses
  private static final double ALL_PERCENT = 100.0;

  private final BoardConnection connection;
  private final CommandedActuators commands;
  private final MotorOutputs motors;
  private final PinSensors sensors;
  private final Optional<RcSwitch> radio;
  private final OptionalDouble batteryDivider;
  private final BoardConnector connector;
  private final StopEcho stopEcho = new StopEcho();
  private Optional<Boolean> reported = Optional.empty(); // whether the board is connected
  private RcSwitch.Position position;
  private double batteryDueS;
  private double greetingDueS;

  public IoioService(ServiceContext context) {
    this(context, Optional.empty());
  }

  public IoioService(ServiceContext context, BoardConnection connection) {
    this(context, Optional.of(connection));
  }

  private IoioService(ServiceContext context, Optional<BoardConnection> made) {
    super(context, "IoioService", STEPS_PER_S);
    IoioVariables variables = settings(IoioVariables.class).get();
    Map<String, PulseOutput> outputs = new LinkedHashMap<>();
    Map<String, ActuatorDescription> descriptions = new LinkedHashMap<>();
    for (IoioVariables.ActuatorPin actuator : variables.actuatorPins()) {
      outputs.put(actuator.name(), PulseOutput.configured(this, actuator.name()));
      descriptions.put(
          actuator.name(), settings(ActuatorDescription.class, actuator.name() + " ").get());
    }
    PinPlan plan = variables.plan();
    commands = new CommandedActuators(this, outputs.keySet(), this::stopNow);
    commands.confirmStopsWhen(() -> stopEcho.isTaken(connector().session()));
    motors = new MotorOutputs(outputs, descriptions, commands, variables.actuatorsTogether());
    RcSwitch rcSwitch = new RcSwitch(settings(RcSwitch.Variables.class).get());
    radio = plan.radio() == PinPlan.NONE ? Optional.empty() : Optional.of(rcSwitch);
    position = radio.isEmpty() ? RcSwitch.Position.AUTOMATIC : RcSwitch.Position.LOST;
    batteryDivider =
        plan.battery() == PinPlan.NONE
            ? OptionalDouble.empty()
            : OptionalDouble.of(variables.batteryDivider());
    sensors = new PinSensors(this, plan);
    registerPublisher(Channels.POWER);
    BoardLogin login = settings(BoardLogin.class).get();
    connection =
        made.orElseGet(
            () ->
                configured(
                    () ->
                        login.connection(
                            variables.connection(),
                            file -> context.configuration().resolve(file).toString())));
    connector = new BoardConnector(connection, plan, variables.boardSilentAfter());
  }

  private static BoardConnection configured(Supplier<BoardConnection> address) {
    try {
      return address.get();
    } catch (BadInputException e) {
      throw new BadInputException("variable \"CONNECTION\": " + e.getMessage(), e);
    }
  }

  @Override
  public List<ActuatorAnnouncement> actuators() {
    return motors.announcements();
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
    connector.start();
  }

  private BoardConnector connector() {
    return connector;
  }

  private void stopNow() {
    Optional<BoardSession> session = connector.session();
    with(session, pins -> drive(pins, clock().micros()));
    stopEcho.stop(session);
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    connector.step(now);
    Optional<BoardSession> session = connector.session();
    sensors.attach(session.map(BoardSession::pins));
    with(session, pins -> act(pins, now));
    sensors.read(now).forEach(state -> publish(Channels.SENSED_STATE, state));
    with(session, pins -> sensors.send(now, session.flatMap(BoardSession::lockstep)));
    commands.available(session.isPresent() ? ALL_PERCENT : 0.0);
    commands.withheld(position != RcSwitch.Position.AUTOMATIC);
    report(session); // last, so that it is the latest error in the health report
    commands.step(nowS);
  }

  private void report(Optional<BoardSession> session) {
    boolean isConnected = session.isPresent();
    String why = connector.trouble();
    if (reported.equals(Optional.of(isConnected)) || !isConnected && why.isEmpty()) {
      return;
    }
    reported = Optional.of(isConnected);
    String board = "the IOIO at " + connection.address();
    if (isConnected) {
      log(board + " is connected: " + session.get().versions());
    } else {
      trouble(board + " is lost: " + why);
    }
  }

  /** Runs an action on the pins if connected; gives the connection up if it is lost. */
  private void with(Optional<BoardSession> session, PinWork work) {
    try {
      work.on(session.map(BoardSession::pins));
    } catch (ConnectionLostException | IOException e) {
      session.ifPresent(lost -> connector.giveUp(lost, "the connection was lost while writing"));
    }
  }

  private interface PinWork {
    void on(Optional<BoardPins> pins) throws ConnectionLostException, IOException;
  }

  private void act(Optional<BoardPins> pins, long now) throws ConnectionLostException {
    listenToRadio(pins, now);
    drive(pins, now);
    if (pins.isPresent()) {
      pins.get().light(led(now).isLit(now));
      if (!connection.isLockstep() && nowS() >= greetingDueS) {
        greetingDueS = nowS() + GREETING_EVERY_S;
        pins.get().greet();
      }
      reportBattery(pins.get());
    }
  }

  private void listenToRadio(Optional<BoardPins> pins, long now) throws ConnectionLostException {
    if (radio.isEmpty()) {
      return;
    }
    RcSwitch rcSwitch = radio.get();
    if (pins.isPresent()) {
      boolean hasMore = true;
      for (int i = 0; hasMore && i < MAX_PULSES_A_STEP; i++) {
        OptionalDouble widthS = pins.get().nextRadioPulse();
        widthS.ifPresent(width -> rcSwitch.accept(width, now));
        hasMore = widthS.isPresent();
      }
    }
    RcSwitch.Position newPosition = rcSwitch.position(now);
    if (newPosition != position) {
      position = newPosition;
      if (position == RcSwitch.Position.LOST && pins.isPresent()) {
        trouble("the radio is lost: commands are withheld");
      } else {
        log("radio: " + position);
      }
    }
  }

  private void drive(Optional<BoardPins> pins, long now) throws ConnectionLostException {
    boolean isAutomatic = position == RcSwitch.Position.AUTOMATIC;
    motors.drive(isAutomatic && commands.mayMove(), pins, now);
  }

  private StatusLed led(long now) {
    if (!commands.mayMove()) {
      return StatusLed.STOPPED;
    }
    return position == RcSwitch.Position.AUTOMATIC ? StatusLed.OBEYS : StatusLed.MANUAL;
  }

  private void reportBattery(BoardPins pins) throws ConnectionLostException {
    OptionalDouble volts = pins.volts();
    if (batteryDivider.isEmpty() || volts.isEmpty() || nowS() < batteryDueS) {
      return;
    }
    batteryDueS = nowS() + BATTERY_EVERY_S;
    double batteryV = volts.getAsDouble() * batteryDivider.getAsDouble();
    publish(Channels.POWER, new BatteryState().sensorName(sensorName()).voltage(batteryV));
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
  }

  /** The board outputs no pulses until the successor has connected. */
  @Override
  protected void releaseToSuccessor() {
    connector.close();
  }

  @Override
  protected void release() {
    with(connector.session(), pins -> motors.drive(false, pins, clock().micros()));
    commands.withdraw();
    connector.close();
  }

  /** Meaning of the status LED for people near the vehicle. */
  private enum StatusLed {
    /** Obeys commands: on. Keep away. */
    OBEYS(1.0, 1.0),
    /** Radio switch on manual, or no receiver: slow blink. */
    MANUAL(1.0, 0.5),
    /** Emergency stop or disarmed: fast blink. */
    STOPPED(0.25, 0.5);

    private final long periodMicros;
    private final long litMicros;

    StatusLed(double periodS, double litShare) {
      periodMicros = Clock.micros(periodS);
      litMicros = Clock.micros(periodS * litShare);
    }

    /** Whether the LED is on at a time of the run [µs]. */
    boolean isLit(long nowMicros) {
      return Math.floorMod(nowMicros, periodMicros) < litMicros;
    }
  }
}
