package org.u2sa.drivers.mavlink;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.drivers.motor.PulseWidth;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;

/** The configuration variables of {@link MavlinkAutopilot}. */
final class MavlinkVariables {
  private static final int CHANNELS = 8;
  private static final Range ID = Range.of(0, 255);

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("udp:14550")
          .describedAs("Where the autopilot is: udp:PORT, tcp:HOST:PORT or serial:DEVICE?baud=N.");

  static final VariableDeclaration<Integer> SYSTEM =
      VariableDeclaration.integer("AUTOPILOT SYSTEM")
          .range(ID)
          .ifAbsent(0)
          .describedAs("The autopilot's MAVLink system ID; 0: whichever is heard first.");

  static final VariableDeclaration<Integer> OWN_SYSTEM =
      VariableDeclaration.integer("OWN SYSTEM")
          .range(Range.of(1, 255))
          .ifAbsent(255)
          .describedAs("System ID that this service speaks as; ArduPilot obeys its SYSID_MYGCS.");

  static final VariableDeclaration<Integer> OWN_COMPONENT =
      VariableDeclaration.integer("OWN COMPONENT")
          .range(Range.of(1, 255))
          .ifAbsent(191)
          .describedAs("Component ID that this service speaks as; 191: onboard computer.");

  static final VariableDeclaration<Double> STATE_RATE =
      VariableDeclaration.number("STATE RATE", "Hz")
          .range(Range.of(0.1, 100.0))
          .ifAbsent(10.0)
          .describedAs("How often the autopilot is asked to send attitude and position.");

  static final VariableDeclaration<Double> STALE_AFTER =
      VariableDeclaration.number("STALE AFTER", "s")
          .range(Range.of(0.1, 10.0))
          .ifAbsent(1.0)
          .describedAs(
              "Age at which what the autopilot's GPS said of its fix and its errors no longer counts.");

  static final VariableDeclaration<Double> HEARTBEAT_TIMEOUT =
      VariableDeclaration.number("HEARTBEAT TIMEOUT", "s")
          .range(Range.of(1.1, 60.0))
          .ifAbsent(3.0)
          .describedAs("Without the autopilot's heartbeat for longer it counts as lost.");

  static final VariableDeclaration<String> COMMANDS =
      VariableDeclaration.text("COMMANDS")
          .oneOf("none", "rc", "velocity", "attitude")
          .ifAbsent("none")
          .describedAs(
              "What commands become: none; radio channels; velocities of the vehicle; attitude and thrust.");

  static final VariableDeclaration<Double> COMMAND_RATE =
      VariableDeclaration.number("COMMAND RATE", "Hz")
          .range(Range.of(1.0, 50.0))
          .ifAbsent(20.0)
          .describedAs("How often commands are sent.");

  static final VariableDeclaration<Double> NEUTRAL_TIME =
      VariableDeclaration.number("NEUTRAL TIME", "s")
          .range(Range.of(0.0, 60.0))
          .ifAbsent(1.0)
          .describedAs(
              "How long neutral is sent when commands end or are stopped, before control is given back.");

  static final VariableDeclaration<Double> SHORTEST_PULSE =
      VariableDeclaration.number("SHORTEST PULSE", "us")
          .range(Range.of(800.0, 2200.0))
          .ifAbsent(1000.0)
          .describedAs("With COMMANDS rc: pulse at -100 %.");

  static final VariableDeclaration<Double> NEUTRAL_PULSE =
      VariableDeclaration.number("NEUTRAL PULSE", "us")
          .range(Range.of(800.0, 2200.0))
          .ifAbsent(1500.0)
          .describedAs("With COMMANDS rc: pulse at 0 %.");

  static final VariableDeclaration<Double> LONGEST_PULSE =
      VariableDeclaration.number("LONGEST PULSE", "us")
          .range(Range.of(800.0, 2200.0))
          .ifAbsent(2000.0)
          .describedAs("With COMMANDS rc: pulse at 100 %.");

  static final VariableDeclaration<Double> FULL_SPEED =
      VariableDeclaration.number("FULL SPEED", "m/s")
          .range(Range.of(0.01, 100.0))
          .ifAbsent(5.0)
          .describedAs("With COMMANDS velocity: speed forward and sideways at 100 %.");

  static final VariableDeclaration<Double> FULL_CLIMB =
      VariableDeclaration.number("FULL CLIMB", "m/s")
          .range(Range.of(0.01, 50.0))
          .ifAbsent(2.0)
          .describedAs("With COMMANDS velocity: speed upwards at 100 %.");

  static final VariableDeclaration<Double> FULL_TURN =
      VariableDeclaration.number("FULL TURN", "rad/s")
          .range(Range.of(0.01, 10.0))
          .ifAbsent(1.0)
          .describedAs("With COMMANDS velocity or attitude: rate of turn at 100 %.");

  static final VariableDeclaration<Double> FULL_TILT =
      VariableDeclaration.number("FULL TILT", "rad")
          .range(Range.of(0.01, 1.5))
          .ifAbsent(0.5)
          .describedAs("With COMMANDS attitude: roll and pitch at 100 %.");

  static final VariableDeclaration<Double> NEUTRAL_THRUST =
      VariableDeclaration.number("NEUTRAL THRUST", "")
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
              VariableDeclaration.text("CHANNEL " + channel + " ACTUATOR")
                  .ifAbsent("")
                  .describedAs("Actuator that moves this radio channel; empty: none."));
      boolean oneWay =
          variables.getVariable(
              VariableDeclaration.flag("CHANNEL " + channel + " ONE WAY")
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
