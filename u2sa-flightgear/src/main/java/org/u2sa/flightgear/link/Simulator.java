package org.u2sa.flightgear.link;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.control.fixedwing.AircraftActuator;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.actuator.ActuatorOwner;
import org.u2sa.service.handover.HandOver;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Connects a simulated Cessna 172 to the system (thesis 4.5.2.1): publishes its measurements and
 * forwards commands. In: actuation, emergency-stop, arming-state. Out: sensed-state, truth, and
 * actuators.
 *
 * <p>While the aircraft is lost, its controls are announced as lost.
 *
 * <p>Commands that are not renewed expire and the controls return to neutral: the aircraft flies or
 * glides at its trim speed and keeps its bank angle. The brakes are applied during an emergency
 * stop and while disarmed.
 */
public final class Simulator extends ProprioceptiveSensor implements ActuatorOwner {
  /** True state of the aircraft, for scoring; flight services must not subscribe to it. */
  public static final Channel<AircraftState> TRUTH =
      Channel.latest("truth", AircraftState.TYPE, AircraftState::sensorName);

  private static final double POLLS_PER_S = 100.0;
  private static final double FULL_PERCENT = 100.0;
  private static final double RICH = 1.0;

  private record Senses(
      @Variable(ifAbsentText = "true")
          @Description(
              "Whether sensed-state has the aircraft's true position, motion and attitude; false: only weight on wheels, engine and height above ground; sensors measure the rest.")
          boolean sensesMotion) {}

  private final boolean sensesMotion;
  private final AircraftLink link;
  private final CommandedActuators commands;
  private long published; // sequence number of the last published reading
  private boolean connected;

  /** Opens the configured link. */
  public Simulator(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Uses the given open link. */
  Simulator(ServiceContext context, AircraftLink link) {
    this(context, Optional.of(link));
  }

  private Simulator(ServiceContext context, Optional<AircraftLink> made) {
    super(context, "Simulator", POLLS_PER_S);
    sensesMotion = settings(Senses.class).get().sensesMotion();
    commands = new CommandedActuators(this, CONTROLS.keySet(), this::write);
    LinkConfiguration configured = new LinkConfiguration(this, context);
    link = made.orElseGet(configured::open);
    registerPublisher(TRUTH);
  }

  /** The controls and their effect on the aircraft. */
  private static final Map<String, String> CONTROLS =
      Map.of(
          "AILERON", "rolls to the right",
          "ELEVATOR", "lowers the nose",
          "RUDDER", "turns the nose to the right",
          "THROTTLE", "power",
          "MIXTURE", "enriches the fuel",
          "FLAPS", "lowers the flaps",
          "LEFT BRAKE", "brakes the left wheel",
          "RIGHT BRAKE", "brakes the right wheel");

  private static final Set<String> BOTH_WAYS = Set.of("AILERON", "ELEVATOR", "RUDDER");

  @Override
  public List<ActuatorAnnouncement> actuators() {
    List<ActuatorAnnouncement> actuators = new ArrayList<>();
    new TreeMap<>(CONTROLS)
        .forEach(
            (name, effect) ->
                actuators.add(
                    new ActuatorAnnouncement()
                        .actuatorName(name)
                        .minimum(BOTH_WAYS.contains(name) ? -FULL_PERCENT : 0.0)
                        .maximum(FULL_PERCENT)
                        .effect(effect)));
    return actuators;
  }

  @Override
  protected void begin() {
    commands.announce(actuators());
  }

  private void write() {
    link.write(controls());
  }

  @Override
  protected void step(double nowS) {
    commands.step(nowS);
    write();
    AircraftReading reading = link.read(clock().micros());
    report(reading);
    commands.available(reading.connected() ? FULL_PERCENT : 0.0);
    if (reading.connected() && reading.sequence() != published) {
      published = reading.sequence();
      publish(Channels.SENSED_STATE, sensesMotion ? state(reading) : airframe(reading));
      publish(TRUTH, state(reading));
    }
  }

  private void report(AircraftReading reading) {
    String trouble = link.trouble();
    if (!trouble.isEmpty()) {
      log(LogLevelEnum.WARN, trouble);
    }
    if (reading.connected() != connected) {
      connected = reading.connected();
      log(
          connected ? LogLevelEnum.INFO : LogLevelEnum.WARN,
          connected ? "aircraft connected" : "aircraft lost");
    }
  }

  private ControlInputs controls() {
    double brakes = commands.mayMove() ? 0.0 : 1.0; // a disarmed aircraft must not roll
    return new ControlInputs(
        fraction("AILERON", 0.0),
        fraction("ELEVATOR", AircraftActuator.TRIMMED_ELEVATOR_PERCENT / FULL_PERCENT),
        fraction("RUDDER", 0.0),
        fraction("THROTTLE", 0.0),
        fraction("MIXTURE", RICH), // a lean mixture would stop the engine permanently
        fraction("FLAPS", 0.0),
        fraction("LEFT BRAKE", brakes),
        fraction("RIGHT BRAKE", brakes));
  }

  private double fraction(String control, double neutral) {
    return commands.percentage(control).orElse(neutral * FULL_PERCENT) / FULL_PERCENT;
  }

  private AircraftState state(AircraftReading reading) {
    AircraftState state = reading.state().copy();
    state.sensorName(sensorName()).timestamp(reading.measuredAtMicros());
    return state;
  }

  /** Readings of wheels, engine and radio altimeter; nothing usable for navigation. */
  private AircraftState airframe(AircraftReading reading) {
    AircraftState whole = reading.state();
    AircraftState state = new AircraftState();
    state.referenceFrame(whole.referenceFrame());
    state.sensorName(sensorName()).timestamp(reading.measuredAtMicros());
    whole.heightAboveGround().ifPresent(state::heightAboveGround);
    whole.engineRpm().ifPresent(state::engineRpm);
    return state
        .weightOnWheels(whole.weightOnWheels())
        .engineStarting(whole.engineStarting())
        .crashed(whole.crashed());
  }

  @Override
  protected void handOver(HandOver state) {
    commands.handOver(state);
  }

  @Override
  protected void takeOver(HandOver state) {
    commands.takeOver(state);
  }

  /** Keeps the controls unchanged until the successor takes over. */
  @Override
  protected void releaseToSuccessor() {
    link.close();
  }

  @Override
  protected void release() {
    try {
      link.write(
          ControlInputs.neutral()
              .withSurfaces(0.0, AircraftActuator.TRIMMED_ELEVATOR_PERCENT / FULL_PERCENT, 0.0));
    } finally {
      commands.withdraw();
      link.close();
    }
  }
}
