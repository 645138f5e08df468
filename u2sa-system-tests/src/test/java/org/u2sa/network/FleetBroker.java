package org.u2sa.network;

import java.nio.file.Path;
import java.util.List;

/** Brokers of a fleet: some on the ground, and one on each vehicle that knows the ground's. */
enum FleetBroker {
  /** A cluster of three, which a vehicle's leaf node finds any one of. */
  NATS(List.of("ground1", "ground2", "ground3"), "ground.conf", "vehicle.conf") {
    @Override
    List<String> program(String host, Path configuration, Path store) {
      return List.of("nats-server", "-c", configuration.toString(), "-n", host, "-sd", "" + store);
    }
  },

  /** One, to which each vehicle's makes a bridge. */
  MOSQUITTO(List.of("ground1"), "mosquitto-ground.conf", "mosquitto-vehicle.conf") {
    @Override
    List<String> program(String host, Path configuration, Path store) {
      return List.of("mosquitto", "-c", configuration.toString());
    }
  };

  private final List<String> grounds;
  private final String ground;
  private final String vehicle;

  FleetBroker(List<String> grounds, String ground, String vehicle) {
    this.grounds = grounds;
    this.ground = ground;
    this.vehicle = vehicle;
  }

  /** Hosts on the ground that carry one. */
  List<String> grounds() {
    return grounds;
  }

  /** Where one on a host is connected to: the last, which no test kills. */
  String lastGround() {
    return grounds.get(grounds.size() - 1);
  }

  /** Name of its configuration in config/fleet. */
  String configuration(String host) {
    return grounds.contains(host) ? ground : vehicle;
  }

  /** The command that runs the one of a host. */
  abstract List<String> program(String host, Path configuration, Path store);
}
