package org.u2sa.drivers.mavlink;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.drivers.motor.PulseWidth;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** The configuration variables of {@link MavlinkAutopilot}. */
record MavlinkVariables(
    @Variable(ifAbsentText = "udp:14550")
        @Description("Address of the autopilot: udp:PORT, tcp:HOST:PORT or serial:DEVICE?baud=N.")
        String connection,
    @Variable(min = 0, max = 255, ifAbsent = 0)
        @Description("MAVLink system ID of the autopilot; 0: the first one that reports.")
        int autopilotSystem,
    @Variable(min = 1, max = 255, ifAbsent = 255)
        @Description("System ID of this service; ArduPilot obeys only the ID in its SYSID_MYGCS.")
        int ownSystem,
    @Variable(min = 1, max = 255, ifAbsent = 191)
        @Description("Component ID of this service; 191: onboard computer.")
        int ownComponent,
    @Variable(unit = "Hz", min = 0.1, max = 100, ifAbsent = 10)
        @Description("Rate of attitude and position requested from the autopilot.")
        double stateRate,
    @Variable(unit = "s", min = 0.1, max = 10, ifAbsent = 1)
        @Description("Age at which the autopilot's GPS status and errors expire.")
        double staleAfter,
    @Variable(unit = "s", min = 1.1, max = 60, ifAbsent = 3)
        @Description("Time without the autopilot's heartbeat after which it counts as lost.")
        double heartbeatTimeout,
    @Variable(
            ifAbsentText = "none",
            oneOf = {"none", "rc", "velocity", "attitude"})
        @Description(
            "How commands are sent: none; as radio channels; as velocities of the vehicle; as attitude and thrust.")
        String commands,
    @Variable(unit = "Hz", min = 1, max = 50, ifAbsent = 20)
        @Description("Rate at which commands are sent.")
        double commandRate,
    @Variable(unit = "s", min = 0, max = 60, ifAbsent = 1)
        @Description(
            "Time for which neutral commands are sent after commands end or are stopped, before control is returned.")
        double neutralTime,
    @Variable(unit = "us", min = 800, max = 2200, ifAbsent = 1000)
        @Description("With COMMANDS rc: pulse at -100 %.")
        double minPulse,
    @Variable(unit = "us", min = 800, max = 2200, ifAbsent = 1500)
        @Description("With COMMANDS rc: pulse at 0 %.")
        double neutralPulse,
    @Variable(unit = "us", min = 800, max = 2200, ifAbsent = 2000)
        @Description("With COMMANDS rc: pulse at 100 %.")
        double maxPulse,
    @Variable(unit = "m/s", min = 0.01, max = 100, ifAbsent = 5)
        @Description("With COMMANDS velocity: speed forward and sideways at 100 %.")
        double fullSpeed,
    @Variable(unit = "m/s", min = 0.01, max = 50, ifAbsent = 2)
        @Description("With COMMANDS velocity: speed upwards at 100 %.")
        double fullClimb,
    @Variable(unit = "rad/s", min = 0.01, max = 10, ifAbsent = 1)
        @Description("With COMMANDS velocity or attitude: turn rate at 100 %.")
        double fullTurn,
    @Variable(unit = "rad", min = 0.01, max = 1.5, ifAbsent = 0.5)
        @Description("With COMMANDS attitude: roll and pitch at 100 %.")
        double fullTilt,
    @Variable(min = 0, max = 1, ifAbsent = 0.5)
        @Description(
            "With COMMANDS attitude: thrust while none is commanded; 0.5 holds height under ArduCopter unless bit 3 of GUID_OPTIONS is set; otherwise give the hover thrust.")
        double neutralThrust) {
  private static final int CHANNELS = 8;

  private record RadioChannel(
      @Variable(ifAbsentText = "")
          @Description("Actuator that moves this radio channel; empty: none.")
          String actuator,
      @Variable(ifAbsentText = "false")
          @Description("Whether 0 % is the minimum pulse, as for a throttle.")
          boolean oneWay) {}

  MavlinkVariables {
    pulses(minPulse, neutralPulse, maxPulse);
  }

  private static PulseWidth pulses(double shortestUs, double neutralUs, double longestUs) {
    return new PulseWidth(shortestUs, neutralUs, longestUs, false, 0.0);
  }

  /**
   * Command form selected by COMMANDS.
   *
   * @param variables variables of the service; the radio channels are declared here
   */
  CommandForm form(Configurator variables) {
    List<RcOverride.Channel> channels = new ArrayList<>();
    for (int channel = 1; channel <= CHANNELS; channel++) {
      RadioChannel said = variables.settings(RadioChannel.class, "CHANNEL " + channel + " ").get();
      if (!said.actuator().isEmpty()) {
        channels.add(new RcOverride.Channel(channel, said.actuator(), said.oneWay()));
      }
    }
    if (commands.equals("rc") && channels.isEmpty()) {
      throw new BadInputException("COMMANDS is rc, but no CHANNEL n ACTUATOR has a name");
    }
    return switch (commands) {
      case "rc" -> new RcOverride(channels, pulses(minPulse, neutralPulse, maxPulse));
      case "velocity" -> new VelocityTarget(fullSpeed, fullClimb, fullTurn);
      case "attitude" -> new AttitudeTarget(fullTilt, fullTurn, neutralThrust);
      default -> new RcOverride(List.of(), PulseWidth.STANDARD); // no channels: sensor only
    };
  }
}
