package org.u2sa.world.grid;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.grid.BeamTrace.FreeBlocks;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/** Blocks count as free only while all their cells are, and skipping them changes no grid. */
class FreeBlocksTest {
  private static final int SIDE = 200; // twelve blocks, and one that the window cuts off
  private static final double CELL = 0.05;
  private static final byte FREEST = -40;
  private static final LogOdds ODDS = new LogOdds(0.85, 0.4, -2.0, 3.5);

  private final GridWindow window = new GridWindow(CELL, SIDE);
  private final FreeBlocks blocks = new FreeBlocks(window, FREEST);

  @Test
  void isFree_oneCellOfABlockIsNot_blockIsNotWhicheverItIs() {
    Arrays.fill(window.cells(), FREEST);
    for (int row = 16; row < 32; row++) {
      for (int column = 48; column < 64; column++) {
        window.cells()[row * SIDE + column] = FREEST + 1;
        blocks.begin();

        assertThat(blocks.isFree(50, 20)).as("cell %s, %s", column, row).isFalse();

        window.cells()[row * SIDE + column] = FREEST;
      }
    }
    blocks.begin();
    assertThat(blocks.isFree(50, 20)).isTrue();
  }

  @Test
  void isFree_blockCutOffByTheWindow_isFalse() {
    Arrays.fill(window.cells(), FREEST);

    assertThat(blocks.isFree(191, 191)).isTrue();
    assertThat(blocks.isFree(192, 191)).isFalse();
    assertThat(blocks.isFree(191, 192)).isFalse();
  }

  @Test
  void isFree_windowIsClearedMovedOrFilled_blocksAreExaminedAgain() {
    OccupancyGrid unknown = window.message(MapFrame.BODY);
    for (Runnable change :
        List.<Runnable>of(
            window::clear, () -> window.move(300L, 300L), () -> window.fill(unknown))) {
      window.move(0L, 0L);
      Arrays.fill(window.cells(), FREEST);
      blocks.begin();
      assertThat(blocks.isFree(20, 20)).isTrue();

      change.run();
      blocks.begin();

      assertThat(blocks.isFree(20, 20)).isFalse();
    }
  }

  /** An entry that remembers free blocks, against new ones that remember nothing. */
  @Test
  void enter_obstaclesComeAndGoWhileTheVehicleDrives_gridIsThatOfAnEntryWithoutMemory() {
    GridWindow other = new GridWindow(CELL, SIDE);
    ScanEntry remembering = new ScanEntry(window, ODDS);
    Random random = new Random(7L);
    double before = 4.0;
    for (int n = 0; n < 400; n++) {
      before = n % 20 == 0 ? 1.0 + 4.0 * random.nextDouble() : before;
      RangeScan scan = scan(random, before);
      StateInformation vehicle =
          new StateInformation()
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(3.0 * Math.sin(0.02 * n))
              .y(0.01 * n)
              .psi(0.03 * n);
      enter(remembering, window, scan, vehicle);
      enter(new ScanEntry(other, ODDS), other, scan, vehicle);

      assertThat(window.cells()).as("scan %s", n).isEqualTo(other.cells());
    }
    assertThat(new FreeBlocks(window, FREEST).isFree(100, 100)).isTrue(); // some were skipped
  }

  private static void enter(
      ScanEntry entry, GridWindow window, RangeScan scan, StateInformation vehicle) {
    window.centre(vehicle.x().orElseThrow(), vehicle.y().orElseThrow());
    Sighting sighting = new Sighting(0L, MapFrame.of(vehicle), Optional.of(vehicle));
    entry.enter(scan, ScanPoses.still(sighting), new ScanEntry.Band(-0.2, 2.0, 1_000.0), -1.0);
  }

  /** Beams more than a cell apart beyond 1.4 m, of which some end at something nearer. */
  private static RangeScan scan(Random random, double range) {
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < 180; i++) {
      boolean isWall = random.nextInt(30) == 0;
      ranges.add(OptionalDouble.of(isWall ? range * random.nextDouble() : range));
    }
    return new RangeScan()
        .sensorName("laser")
        .minRange(0.1)
        .maxRange(10.0)
        .beams(-Math.PI, Math.toRadians(2.0), ranges);
  }
}
