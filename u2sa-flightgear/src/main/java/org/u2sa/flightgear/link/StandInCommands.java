package org.u2sa.flightgear.link;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.flightgear.protocol.ProtocolFiles;

/**
 * Properties and commands of the stand-in's property server: readings, speed-up, and FlightGear's
 * channel commands.
 */
final class StandInCommands {
  private static final String SPEED_UP = "/sim/speed-up";
  private static final int CONFIG_PARTS = 8; // generic,socket,out,20,127.0.0.1,5501,tcp,u2sa-out

  private final StandInFlightGear standIn;
  private final Map<String, String> configs = new HashMap<>(); // channel configurations by path

  StandInCommands(StandInFlightGear standIn) {
    this.standIn = standIn;
  }

  /** Records how a channel was opened, for later queries. */
  void noteConfig(String name, String direction, String host, int port, String protocol) {
    configs.put(
        "/io/channels/" + name + "/config",
        "generic,socket," + direction + ",20," + host + "," + port + ",tcp," + protocol);
  }

  /** Returns the value of a property as text; empty if unset. */
  String get(String path) {
    OutLine said = standIn.said();
    for (OutField field : OutField.values()) {
      if (field.node().equals(path)) {
        return said.format().split(",", -1)[field.ordinal()];
      }
    }
    return path.equals(SPEED_UP)
        ? String.valueOf(standIn.speedUp())
        : configs.getOrDefault(path, "");
  }

  /** Sets a property. */
  void set(String path, String value) {
    if (path.equals(SPEED_UP) && value.matches("[0-9]{1,2}([.][0-9]+)?")) {
      standIn.speedUp(Double.parseDouble(value));
    }
  }

  /**
   * Runs a command with arguments "name=value".
   *
   * @return whether it succeeded
   */
  boolean run(String command, List<String> arguments) {
    Map<String, String> values = new HashMap<>();
    for (String argument : arguments) {
      int equals = argument.indexOf('=');
      if (equals > 0) {
        values.put(argument.substring(0, equals), argument.substring(equals + 1));
      }
    }
    String name = values.getOrDefault("name", "");
    return switch (command) {
      case "exit" -> {
        standIn.exit();
        yield true;
      }
      case "remove-io-channel" -> standIn.remove(name);
      case "add-io-channel" -> add(name, values.getOrDefault("config", "").split(",", -1));
      default -> false;
    };
  }

  private boolean add(String name, String[] config) {
    if (name.isEmpty() || config.length != CONFIG_PARTS || !config[5].matches("[0-9]{1,5}")) {
      return false;
    }
    int port = Integer.parseInt(config[5]);
    noteConfig(name, config[2], config[4], port, config[7]);
    if (config[2].equals("out") && config[7].equals(ProtocolFiles.OUT)) {
      return standIn.add(name, () -> new StandInOutput(config[4], port));
    }
    return config[2].equals("in")
        && config[7].equals(ProtocolFiles.IN)
        && standIn.add(name, () -> new StandInInput(standIn.host(), port));
  }
}
