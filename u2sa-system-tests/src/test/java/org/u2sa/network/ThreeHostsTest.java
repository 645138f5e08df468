package org.u2sa.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Comparator;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.u2sa.testkit.Repository;

/** Flights on three hosts, nine minutes each. Needs root, iproute2 and Mosquitto. */
@Tag("network")
class ThreeHostsTest {
  private static final Set<String> NOBODY = Set.of();

  private static final String HUB = ThreeHosts.HUB;
  private static final String AIRCRAFT = ThreeHosts.AIRCRAFT;
  private static final String PILOT = ThreeHosts.PILOT;
  private static final Set<String> SENSING = Set.of("Simulator", "StateEstimator");
  private static final Set<String> PILOTING = Set.of("PathPlanner", "Control");

  @Test
  void fly_mosquittoAndPartsByOnly_goesOnThroughCutsKillsAndLoss() throws Exception {
    try (NetworkFlight flight = flight("mosquitto", Broker.MOSQUITTO)) {
      ThreeHosts hosts = flight.hosts();
      Lan lan = hosts.lan();
      flight.suffer("pilot cut", () -> lan.cut(PILOT), 2.0, () -> lan.mend(PILOT), NOBODY);
      flight.suffer("pilot cut", () -> lan.cut(PILOT), 10.0, () -> lan.mend(PILOT), PILOTING);
      flight.suffer("broker killed", hosts::killBroker, 3.0, hosts::startBroker, NOBODY);
      slowDown(flight, PILOT);
      flight.suffer(
          "aircraft silent", () -> lan.silence(AIRCRAFT), 10.0, () -> lan.mend(AIRCRAFT), SENSING);
      flight.suffer("pilot vanishes", vanish(hosts, PILOT), 10.0, back(hosts, PILOT), PILOTING);
      flight.land(Set.of("PathPlanner", "Control", "Launcher-PathPlanner"));
      flight.balance();

      assertThat(flight.failures()).isEmpty();
    }
  }

  @Test
  void fly_embeddedBrokerAndHostsInTheFile_goesOnThroughCutsKillsAndLoss() throws Exception {
    try (NetworkFlight flight = flight("embedded", Broker.EMBEDDED)) {
      ThreeHosts hosts = flight.hosts();
      Lan lan = hosts.lan();
      flight.suffer("aircraft cut", () -> lan.cut(AIRCRAFT), 2.0, () -> lan.mend(AIRCRAFT), NOBODY);
      flight.suffer(
          "aircraft cut", () -> lan.cut(AIRCRAFT), 10.0, () -> lan.mend(AIRCRAFT), SENSING);
      flight.suffer("broker killed", hosts::killBroker, 3.0, hosts::startBroker, NOBODY);
      slowDown(flight, AIRCRAFT);
      flight.suffer("hub cut", () -> lan.cut(HUB), 6.0, () -> lan.mend(HUB), NOBODY);
      flight.suffer(
          "aircraft vanishes", vanish(hosts, AIRCRAFT), 10.0, back(hosts, AIRCRAFT), SENSING);
      flight.land(Set.of("Simulator", "StateEstimator", "Launcher-Simulator"));
      flight.balance();
      flight.vanishForGood(PILOT, PILOTING, "Launcher-PathPlanner");

      assertThat(flight.failures()).isEmpty();
    }
  }

  private static void slowDown(NetworkFlight flight, String host) throws Exception {
    Lan lan = flight.hosts().lan();
    String name = host + " 200 ± 40 ms, 5 % loss";
    flight.suffer(name, () -> lan.shape(host, 200.0, 40.0, 5.0), 20.0, () -> {}, NOBODY);
    flight.suffer(
        host + " fast again", () -> lan.shape(host, 0.0, 0.0, 0.0), 1.0, () -> {}, NOBODY);
  }

  private static NetworkFlight.Fault vanish(ThreeHosts hosts, String host) {
    return () -> {
      hosts.lan().cut(host);
      hosts.kill(host);
    };
  }

  private static NetworkFlight.Fault back(ThreeHosts hosts, String host) {
    return () -> {
      hosts.lan().mend(host);
      hosts.start(host);
    };
  }

  private static NetworkFlight flight(String name, Broker broker) throws Exception {
    Path folder = emptied("network-" + name);
    return new NetworkFlight(Repository.root(), folder, broker);
  }

  /** The folder, without what an earlier run left in it. */
  static Path emptied(String name) throws IOException {
    Path folder = Paths.get("target", name).toAbsolutePath();
    if (Files.exists(folder)) {
      try (var files = Files.walk(folder)) {
        for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
    return Files.createDirectories(folder);
  }
}
