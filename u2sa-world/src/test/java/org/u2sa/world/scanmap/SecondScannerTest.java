package org.u2sa.world.scanmap;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.frame.Point;
import org.u2sa.world.ModelledWorld;
import org.u2sa.world.WorldModeler;

/** A vehicle with a laser whose scans are matched, and another behind. */
class SecondScannerTest {
  @Test
  void grid_obstacleSeenByTheSecondScannerOnly_isOccupied() {
    try (ModelledWorld world = new ModelledWorld()) {
      world.kit.with("MODELLERS", "SCAN MAP").start(WorldModeler::new);
      Random random = new Random(4);
      for (int i = 0; i < 20; i++) {
        RangeScan rear = ModelledWorld.wallAhead(1.0).sensorName("Rear").psi(Math.PI);
        world.kit.send(Channels.STATE, ModelledWorld.local(0.0, 0.0, 0.0));
        world.kit.send(
            Channels.SCANS, Room.furnished().scan(new Pose2(3.0, 2.5, 0.0), 12.0, 0.01, random));
        world.kit.send(Channels.SCANS, rear);
        world.kit.settle();
        world.kit.advance(0.1);
      }

      OccupancyGrid grid = world.kit.latest(Channels.GRID).orElseThrow();
      assertThat(OccupancyGrid.probability(grid.cellAt(Point.of(-1.0, 0.0, 0.0))))
          .isGreaterThan(0.6);
    }
  }
}
