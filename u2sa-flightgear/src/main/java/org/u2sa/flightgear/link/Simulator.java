package org.u2sa.flightgear.link;

import java.util.Set;
import org.u2sa.flightgear.AircraftState;
import org.u2sa.interfaces.LogLevelEnum;
import org.u2sa.interfaces.Range;
import org.u2sa.interfaces.Variable;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ActuatorCommand;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.CommandHold;
import org.u2sa.service.ProprioceptiveSensor;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Joins a simulated Cessna 172 to the system (thesis 4.5.2.1): publishes what it measures and
 * passes commands on. In: actuation. Out: sensed-state, and truth.
 *
 * <p>Commands that nobody renews expire, and the controls go neutral: the aircraft glides with its
 * wings where they are.
 */
public final class Simulator extends ProprioceptiveSensor {
  private static final double POLLS_PER_S = 100.0;
  private static final double FULL_PERCENT = 100.0;
  private static final double RICH = 1.0;

  private static final Variable<Double> COMMAND_EXPIRY =
      Variable.number("COMMAND EXPIRY", "s")
          .range(Range.of(0.01, 60.0))
          .ifAbsent(0.5)
          .describedAs("Time without a command after which a control goes neutral.");

  private final AircraftLink link;
  private final CommandHold commands;
  private long published; // sequence of the reading published last
  private boolean connected;

  /** Opens the link that the configuration names. */
  public Simulator(ServiceContext context) {
    super(context, "Simulator", POLLS_PER_S);
    commands = new CommandHold(clock(), getVariable(COMMAND_EXPIRY), CONTROLS);
    link = new LinkConfiguration(this, context).open();
    registerPublisher(FlightChannels.TRUTH);
    registerSubscriber(Channels.ACTUATION);
  }

  private static final Set<String> CONTROLS =
      Set.of(
          "AILERON",
          "ELEVATOR",
          "RUDDER",
          "THROTTLE",
          "MIXTURE",
          "FLAPS",
          "LEFT BRAKE",
          "RIGHT BRAKE");

  @Override
  public void callback(U2SAData data) {
    if (!(data instanceof ActuatorCommand command)) {
      unexpected(data);
    } else if (!commands.accept(command)) {
      log(
          LogLevelEnum.WARN,
          "refused " + command + ": for no control of this aircraft, or too old");
    }
  }

  @Override
  protected void step(double nowS) {
    link.write(controls());
    AircraftReading reading = link.read(clock().micros());
    report(reading);
    if (reading.connected() && reading.sequence() != published) {
      published = reading.sequence();
      publish(Channels.SENSED_STATE, state(reading));
      publish(FlightChannels.TRUTH, state(reading));
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
          connected ? "the aircraft is there" : "the aircraft is lost");
    }
  }

  private ControlInputs controls() {
    return new ControlInputs(
        fraction("AILERON", 0.0),
        fraction("ELEVATOR", 0.0),
        fraction("RUDDER", 0.0),
        Math.max(0.0, fraction("THROTTLE", 0.0)),
        Math.max(0.0, fraction("MIXTURE", RICH)), // a lean mixture would stop the engine for good
        Math.max(0.0, fraction("FLAPS", 0.0)),
        Math.max(0.0, fraction("LEFT BRAKE", 0.0)),
        Math.max(0.0, fraction("RIGHT BRAKE", 0.0)));
  }

  private double fraction(String control, double neutral) {
    return commands.percentage(control).orElse(neutral * FULL_PERCENT) / FULL_PERCENT;
  }

  private AircraftState state(AircraftReading reading) {
    AircraftState state = new AircraftState();
    state.timestamp(reading.measuredAtMicros());
    state
        .sensorName(sensorName())
        .referenceFrame(ReferenceFrame.GLOBAL)
        .x(reading.longitudeDeg())
        .y(reading.latitudeDeg())
        .z(reading.altitudeM())
        .xDot(reading.eastMps())
        .yDot(reading.northMps())
        .zDot(reading.upMps())
        .phi(reading.rollRad())
        .theta(reading.pitchRad())
        .psi(reading.headingRad())
        .phiDot(reading.rollRateRadPerS())
        .thetaDot(reading.pitchRateRadPerS())
        .psiDot(reading.headingRateRadPerS())
        .fluidxDot(reading.airForwardMps())
        .fluidyDot(reading.airLeftMps())
        .fluidzDot(reading.airDownMps());
    return state
        .heightAboveGround(reading.heightAboveGroundM())
        .calibratedAirspeed(reading.calibratedAirspeedMps())
        .engineRpm(reading.engineRpm())
        .weightOnWheels(reading.weightOnWheels())
        .engineStarting(reading.engineStarting())
        .crashed(reading.crashed());
  }

  @Override
  protected void release() {
    try {
      link.write(new ControlInputs(0.0, 0.0, 0.0, 0.0, RICH, 0.0, 0.0, 0.0));
    } finally {
      link.close();
    }
  }
}
