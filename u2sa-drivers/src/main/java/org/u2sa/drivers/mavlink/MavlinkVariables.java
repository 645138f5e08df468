package org.u2sa.drivers.mavlink;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.drivers.motor.PulseWidth;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.Variable;

/** The configuration variables of {@link MavlinkAutopilot}. */
final class MavlinkVariables {
  private static final int CHANNELS = 8;
  private static final Range ID = Range.of(0, 255);

  static final Variable<String> CONNECTION =
      Variable.text("CONNECTION")
          .ifAbsent("udp:14550")
          .describedAs("Where the autopilot is: udp:PORT, tcp:HOST:PORT or serial:DEVICE?baud=N.");

  static final Variable<Integer> SYSTEM =
      Variable.integer("AUTOPILOT SYSTEM")
          .range(ID)
          .ifAbsent(0)
          .describedAs("The autopilot's MAVLink system ID; 0: whichever is heard first.");

  static final Variable<Integer> OWN_SYSTEM =
      Variable.integer("OWN SYSTEM")
          .range(Range.of(1, 255))
          .ifAbsent(255)
          .describedAs("System ID that this service speaks as; ArduPilot obeys its SYSID_MYGCS.");

  static final Variable<Integer> OWN_COMPONENT =
      Variable.integer("OWN COMPONENT")
          .range(Range.of(1, 255))
          .ifAbsent(191)
          .describedAs("Component ID that this service speaks as; 191: onboard computer.");

  static final Variable<Double> STATE_RATE =
      Variable.number("STATE RATE", "Hz")
          .range(Range.of(0.1, 100.0))
          .ifAbsent(10.0)
          .describedAs("How often the autopilot is asked to send attitude and position.");

  static final Variable<Double> STALE_AFTER =
      Variable.number("STALE AFTER", "s")
          .range(Range.of(0.1, 10.0))
          .ifAbsent(1.0)
          .describedAs(
              "Age at which what the autopilot's GPS said of its fix and its errors no longer counts.");

  static final Variable<Double> HEARTBEAT_TIMEOUT =
      Variable.number("HEARTBEAT TIMEOUT", "s")
          .range(Range.of(1.1, 60.0))
          .ifAbsent(3.0)
          .describedAs("Without the autopilot's heartbeat for longer it counts as lost.");

  static final Variable<String> COMMANDS =
      Variable.text("COMMANDS")
          .oneOf("none", "rc", "velocity", "attitude")
          .ifAbsent("none")
          .describedAs(
              "What commands become: none; radio channels; velocities of the vehicle; attitude and thrust.");

  static final Variable<Double> COMMAND_RATE =
      Variable.number("COMMAND RATE", "Hz")
          .range(Range.of(1.0, 50.0))
          .ifAbsent(20.0)
          .describedAs("How often commands are sent.");

  static final Variable<Double> NEUTRAL_TIME =
      Variable.number("NEUTRAL TIME", "s")
          .range(Range.of(0.0, 60.0))
          .ifAbsent(1.0)
          .describedAs(
              "How long neutral is sent when commands end or are stopped, before control is given back.");

  static final Variable<Double> SHORTEST_PULSE =
      Variable.number("SHORTEST PULSE", "us")
          .range(Range.of(800.0, 2200.0))
          .ifAbsent(1000.0)
          .describedAs("With COMMANDS rc: pulse at -100 %.");

  static final Variable<Double> NEUTRAL_PULSE =
      Variable.number("NEUTRAL PULSE", "us")
          .range(Range.of(800.0, 2200.0))
          .ifAbsent(1500.0)
          .describedAs("With COMMANDS rc: pulse at 0 %.");

  static final Variable<Double> LONGEST_PULSE =
      Variable.number("LONGEST PULSE", "us")
          .range(Range.of(800.0, 2200.0))
          .ifAbsent(2000.0)
          .describedAs("With COMMANDS rc: pulse at 100 %.");

  static final Variable<Double> FULL_SPEED =
      Variable.number("FULL SPEED", "m/s")
          .range(Range.of(0.01, 100.0))
          .ifAbsent(5.0)
          .describedAs("With COMMANDS velocity: speed forward and sideways at 100 %.");

  static final Variable<Double> FULL_CLIMB =
      Variable.number("FULL CLIMB", "m/s")
          .range(Range.of(0.01, 50.0))
          .ifAbsent(2.0)
          .describedAs("With COMMANDS velocity: speed upwards at 100 %.");

  static final Variable<Double> FULL_TURN =
      Variable.number("FULL TURN", "rad/s")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(1.0)
          .describedAs("With COMMANDS velocity or attitude: rate of turn at 100 %.");

  static final Variable<Double> FULL_TILT =
      Variable.number("FULL TILT", "rad")
          .range(Range.of(0.01, 1.5))
          .ifAbsent(0.5)
          .describedAs("With COMMANDS attitude: roll and pitch at 100 %.");

  static final Variable<Double> NEUTRAL_THRUST =
      Variable.number("NEUTRAL THRUST", "")
          .range(Range.of(0.0, 1.0))
          .ifAbsent(0.5)
          .describedAs(
              "With COMMANDS attitude: thrust while none is commanded; 0.5 holds height under ArduCopter unless its GUID_OPTIONS has bit 3, elsewhere name the hover thrust.");

  private MavlinkVariables() {}

  /** Declares and reads all that concern commands. */
  static CommandForm form(Configurator variables) {
    CommandForm rc = rc(variables);
    CommandForm velocity =
        new VelocityTarget(
            variables.getVariable(FULL_SPEED),
            variables.getVariable(FULL_CLIMB),
            variables.getVariable(FULL_TURN));
    CommandForm attitude =
        new AttitudeTarget(
            variables.getVariable(FULL_TILT),
            variables.getVariable(FULL_TURN),
            variables.getVariable(NEUTRAL_THRUST));
    switch (variables.getVariable(COMMANDS)) {
      case "rc":
        if (rc.axes().isEmpty()) {
          throw new BadInputException("COMMANDS is rc, but no CHANNEL n ACTUATOR has a name");
        }
        return rc;
      case "velocity":
        return velocity;
      case "attitude":
        return attitude;
      default:
        return new NoCommands();
    }
  }

  private static CommandForm rc(Configurator variables) {
    List<RcOverride.Channel> channels = new ArrayList<>();
    for (int channel = 1; channel <= CHANNELS; channel++) {
      String actuator =
          variables.getVariable(
              Variable.text("CHANNEL " + channel + " ACTUATOR")
                  .ifAbsent("")
                  .describedAs("Actuator that moves this radio channel; empty: none."));
      boolean oneWay =
          variables.getVariable(
              Variable.flag("CHANNEL " + channel + " ONE WAY")
                  .ifAbsent(false)
                  .describedAs("Whether 0 % is the shortest pulse, as of a throttle."));
      if (!actuator.isEmpty()) {
        channels.add(new RcOverride.Channel(channel, actuator, oneWay));
      }
    }
    PulseWidth width =
        new PulseWidth(
            variables.getVariable(SHORTEST_PULSE),
            variables.getVariable(NEUTRAL_PULSE),
            variables.getVariable(LONGEST_PULSE),
            false,
            0.0);
    return new RcOverride(channels, width);
  }
}
