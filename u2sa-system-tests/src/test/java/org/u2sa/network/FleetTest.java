package org.u2sa.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.u2sa.testkit.Repository;

/**
 * Two rovers drive their loops, four minutes each, with a broker on each and others on the ground.
 * Needs root, iproute2, Mosquitto and nats-server (docs/fleet.md).
 */
@Tag("network")
class FleetTest {
  private static final int LOOPS = 2;

  @Test
  void drive_natsClusterAndLeafNodes_goesOnThroughKillCutAndLoss() throws Exception {
    Assumptions.assumeTrue(
        isOnPath("nats-server"), "nats-server is not on the path: docs/fleet.md");
    try (FleetDrive drive = drive("nats", FleetBroker.NATS)) {
      Fleet fleet = drive.fleet();
      for (String node : List.of("ground1", "ground2")) { // one of them may have a rover's leaf
        drive.suffer(
            node + " killed", () -> fleet.killBroker(node), 5.0, () -> fleet.startBroker(node));
      }
      cutAndSlow(drive);
      drive.balance();
      drive.finish();

      assertThat(drive.failures()).isEmpty();
    }
  }

  @Test
  void drive_bridgedMosquittos_goesOnThroughKillCutAndLoss() throws Exception {
    try (FleetDrive drive = drive("mosquitto-bridge", FleetBroker.MOSQUITTO)) {
      Fleet fleet = drive.fleet();
      drive.suffer(
          "ground1 killed",
          () -> fleet.killBroker("ground1"),
          5.0,
          () -> fleet.startBroker("ground1"));
      cutAndSlow(drive);
      drive.balance();
      drive.finish();

      assertThat(drive.failures()).isEmpty();
    }
  }

  private static void cutAndSlow(FleetDrive drive) throws Exception {
    Lan lan = drive.fleet().lan();
    drive.suffer("rover1 cut", () -> lan.cut(Fleet.CUT), 10.0, () -> lan.mend(Fleet.CUT));
    drive.suffer(
        "rover2 200 ± 40 ms, 5 % loss",
        () -> lan.shape(Fleet.SLOWED, 200.0, 40.0, 5.0),
        20.0,
        () -> lan.shape(Fleet.SLOWED, 0.0, 0.0, 0.0));
  }

  private static boolean isOnPath(String program) {
    return Stream.of(System.getenv("PATH").split(File.pathSeparator))
        .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
  }

  private static FleetDrive drive(String name, FleetBroker kind) throws Exception {
    Path folder = ThreeHostsTest.emptied("fleet-" + name);
    return new FleetDrive(Repository.root(), folder, kind, LOOPS);
  }
}
