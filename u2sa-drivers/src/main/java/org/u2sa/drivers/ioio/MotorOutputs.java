package org.u2sa.drivers.ioio;

import ioio.lib.api.exception.ConnectionLostException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.drivers.motor.PulseOutput;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.service.CommandedActuators;
import org.u2sa.service.actuator.ActuatorDescription;

/** Actuators on the board: converts commands to pulses. Confined to the service's thread. */
final class MotorOutputs {
  private static final double FULL_PERCENT = 100.0;
  private static final Map<String, String> EFFECTS =
      Map.of(
          "LEFT MOTOR", "drives the left side forward",
          "RIGHT MOTOR", "drives the right side forward",
          "THROTTLE", "drives forward",
          "STEERING", "steers to the right");

  private final Map<String, PulseOutput> outputs; // in pin order
  private final Map<String, ActuatorDescription> descriptions;
  private final CommandedActuators commands;
  private final boolean together;

  /**
   * @param descriptions description of each output, for announcements
   * @param together whether all are neutral while any lacks a command
   */
  MotorOutputs(
      Map<String, PulseOutput> outputs,
      Map<String, ActuatorDescription> descriptions,
      CommandedActuators commands,
      boolean together) {
    this.outputs = new LinkedHashMap<>(outputs);
    this.descriptions = descriptions;
    this.commands = commands;
    this.together = together;
  }

  List<ActuatorAnnouncement> announcements() {
    List<ActuatorAnnouncement> all = new ArrayList<>();
    for (String name : outputs.keySet()) {
      ActuatorAnnouncement announcement =
          new ActuatorAnnouncement()
              .actuatorName(name)
              .minimum(-FULL_PERCENT)
              .maximum(FULL_PERCENT)
              .effect(EFFECTS.getOrDefault(name, "moves"));
      all.add(descriptions.get(name).addTo(announcement));
    }
    return all;
  }

  /**
   * Sets each output's pulse.
   *
   * @param mayMove false forces neutral
   * @param pins empty while disconnected; outputs restart at neutral after reconnection
   */
  void drive(boolean mayMove, Optional<BoardPins> pins, long nowMicros)
      throws ConnectionLostException {
    List<OptionalDouble> percentages = new ArrayList<>();
    boolean isMissing = false;
    for (String name : outputs.keySet()) {
      OptionalDouble percentage = commands.percentage(name);
      isMissing |= percentage.isEmpty();
      percentages.add(percentage);
    }
    boolean isNeutral = !mayMove || pins.isEmpty() || together && isMissing;
    int index = 0;
    for (PulseOutput output : outputs.values()) {
      OptionalDouble wanted = isNeutral ? OptionalDouble.empty() : percentages.get(index);
      double widthS = output.seconds(wanted, nowMicros);
      if (pins.isPresent()) {
        pins.get().pulse(index, widthS);
      }
      index++;
    }
  }
}
