package org.u2sa.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.world.ModelledWorld.local;
import static org.u2sa.world.ModelledWorld.seen;
import static org.u2sa.world.ModelledWorld.wallAhead;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;

/** Whether readers of the objects learn that a sensor is missing in them. */
class AwaitedSensorsTest {
  @TempDir private Path folder;
  private final ModelledWorld world = new ModelledWorld();

  @AfterEach
  void close() {
    world.close();
  }

  private List<String> awaited() {
    return world.kit.latest(Channels.OBJECTS).orElseThrow().awaited();
  }

  private void scan(int ticks, String... scanners) {
    for (int i = 0; i < ticks; i++) {
      for (String scanner : scanners) {
        world.kit.send(Channels.SCANS, wallAhead(4.0).sensorName(scanner));
      }
      world.stand(1);
    }
  }

  @Test
  void gridWithoutAScan_awaitsAScannerUntilOneScans() {
    world.kit.start(WorldModeler::new);
    world.stand(20);
    assertThat(awaited()).containsExactly("any scanner");
    assertThat(world.remarks()).contains("AWAITED: silent: any scanner");

    scan(5, "Lidar");
    assertThat(awaited()).isEmpty();
    assertThat(world.remarks()).doesNotContain("AWAITED");
  }

  @Test
  void scannerFallsSilent_isAwaitedAfterASecondAlthoughTheMapIsPublishedOn() {
    world.kit.start(WorldModeler::new);
    scan(5, "Lidar");
    world.stand(8);
    assertThat(awaited()).isEmpty();
    world.stand(5);
    assertThat(awaited()).containsExactly("Lidar");
    assertThat(world.kit.latest(Channels.GRID)).isPresent();

    scan(5, "Lidar");
    assertThat(awaited()).isEmpty();
  }

  /** Objects that it saw before are unknown until they are confirmed again. */
  @Test
  void restart_scannerIsAwaitedUntilItHasScannedThrice() {
    WorldModeler first = world.kit.start(WorldModeler::new);
    scan(1, "Lidar");
    assertThat(awaited()).isEmpty();
    world.kit.restart(first, WorldModeler::new);
    scan(1, "Lidar");
    assertThat(awaited()).isNotEmpty();
    scan(1, "Lidar");
    assertThat(awaited()).isNotEmpty();
    scan(2, "Lidar");
    assertThat(awaited()).isEmpty();
  }

  @Test
  void slowScanner_mayTakeTwiceItsUsualInterval() {
    world.kit.start(WorldModeler::new);
    for (int i = 0; i < 4; i++) {
      scan(1, "Sonar");
      world.stand(14);
    }
    assertThat(awaited()).isEmpty();
    world.stand(14);
    assertThat(awaited()).isEmpty();

    world.stand(5);

    assertThat(awaited()).containsExactly("Sonar");
  }

  @Test
  void oneGapOfAFastScanner_givesItNoMorePatience() {
    world.kit.start(WorldModeler::new);
    scan(5, "Lidar");
    world.stand(30);
    scan(1, "Lidar");
    assertThat(awaited()).isEmpty();

    world.stand(12);

    assertThat(awaited()).containsExactly("Lidar");
  }

  @Test
  void scannerRepeatsItsLastScan_isAwaited() {
    world.kit.start(WorldModeler::new);
    scan(5, "Lidar");
    var last = wallAhead(4.0).sensorName("Lidar");
    last.timestamp(world.kit.clock().micros());
    for (int i = 0; i < 15; i++) {
      world.kit.publish(Channels.SCANS, last);
      world.stand(1);
    }
    assertThat(awaited()).containsExactly("Lidar");
  }

  @Test
  void oneOfTwoScannersFallsSilent_isAwaited() {
    world.kit.start(WorldModeler::new);
    scan(5, "Front", "Rear");
    scan(15, "Front");
    assertThat(awaited()).containsExactly("Rear");
  }

  @Test
  void objectsOnly_emptyLawnOrSky_awaitsNothing() {
    world.kit.with("MODELLERS", "OBJECTS").start(WorldModeler::new);
    world.tick(local(0.0, 0.0, 0.0), seen("a", 3.0, 0.0));
    world.stand(100);
    assertThat(awaited()).isEmpty();
  }

  @Test
  void gridOfAWorldFile_awaitsNothing() throws Exception {
    Path file = Files.writeString(folder.resolve("world.xml"), "<world/>");
    world.kit.with("WORLD", file.toString()).start(WorldModeler::new);
    world.stand(20);
    assertThat(awaited()).isEmpty();
  }

  @Test
  void expectedSensors_onlyTheyAreAwaited() {
    world.kit.with("MODELLERS", "OBJECTS").with("EXPECTED SENSORS", "Camera, Lidar");
    world.kit.with("SILENT AFTER", 2.0).start(WorldModeler::new);
    world.stand(1);
    assertThat(awaited()).containsExactly("Camera", "Lidar");

    world.kit.send(Channels.SENSED_OBJECTS, seen("a", 3.0, 0.0));
    scan(3, "Lidar", "Rear");
    assertThat(awaited()).isEmpty();
    world.stand(12);
    assertThat(awaited()).isEmpty();
    world.stand(10);
    assertThat(awaited()).containsExactly("Camera", "Lidar");
  }

  /** As a radar on an empty sea. */
  @Test
  void expectedSensorSeesNothing_isNotAwaitedAndMapsNothing() {
    world.kit.with("MODELLERS", "OBJECTS").with("EXPECTED SENSORS", "Camera");
    world.kit.start(WorldModeler::new);
    for (int i = 0; i < 30; i++) {
      world.kit.send(Channels.SENSED_OBJECTS, seen("none", 3.0, 0.0).confidence(0.0));
      world.stand(1);
    }
    assertThat(awaited()).isEmpty();
    assertThat(world.objects()).isEmpty();
  }

  @Test
  void swap_scannerSilentSince_isAwaited() {
    world.kit.with("MODELLERS", "OBJECTS");
    WorldModeler first = world.kit.start(WorldModeler::new);
    scan(5, "Lidar");
    world.kit.swap(first, WorldModeler::new);
    world.stand(15);
    assertThat(awaited()).containsExactly("Lidar");
  }
}
