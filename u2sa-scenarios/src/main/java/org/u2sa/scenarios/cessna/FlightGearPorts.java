package org.u2sa.scenarios.cessna;

import org.u2sa.core.launch.LaunchOptions;
import picocli.CommandLine.Option;

/** Options for the TCP ports between FlightGear and this program. */
final class FlightGearPorts {
  @Option(
      names = "--out-port",
      paramLabel = "PORT",
      defaultValue = "5501",
      description =
          "Port on which U2SA listens for FlightGear's readings. Default: ${DEFAULT-VALUE}.")
  private int out;

  @Option(
      names = "--in-port",
      paramLabel = "PORT",
      defaultValue = "5502",
      description = "Port on which FlightGear listens for controls. Default: ${DEFAULT-VALUE}.")
  private int in;

  @Option(
      names = "--props-port",
      paramLabel = "PORT",
      defaultValue = "5503",
      description =
          "Port of FlightGear's property server, used to restore a lost link; 0: none. Default: ${DEFAULT-VALUE}.")
  private int property;

  int out() {
    return out;
  }

  int in() {
    return in;
  }

  int property() {
    return property;
  }

  /** Points the Simulator service at FlightGear. */
  void configure(LaunchOptions options, String host) {
    configure(options, host, out, in, property);
  }

  /** Points the Simulator service at FlightGear, or at another program with its protocol. */
  static void configure(LaunchOptions options, String host, int out, int in, int property) {
    options
        .override("Simulator", "LINK", "flightgear")
        .override("Simulator", "RATE", 100.0)
        .override("Simulator", "FLIGHTGEAR HOST", host)
        .override("Simulator", "FLIGHTGEAR OUT PORT", out)
        .override("Simulator", "FLIGHTGEAR IN PORT", in)
        .override("Simulator", "FLIGHTGEAR PROPERTY PORT", property);
  }
}
