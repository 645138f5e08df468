package org.u2sa.planning.seen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/** A map of about 1.5 km from south to north on which the ground rises to the north-east. */
class GroundMapTest {
  private static final int CELLS = 40;
  private static final double CELL_DEG = 0.0004;
  private static final double SOUTH_DEG = 47.0;
  private static final double WEST_DEG = 11.0;

  @TempDir Path folder;

  private HeightGrid grid;
  private GroundMap map;
  private PlanningPlane plane;

  @BeforeEach
  void start() throws IOException {
    StringBuilder text = new StringBuilder("ncols " + CELLS + "\nnrows " + CELLS + "\n");
    text.append("xllcorner " + WEST_DEG + "\nyllcorner " + SOUTH_DEG + "\n");
    text.append("cellsize " + CELL_DEG + "\nNODATA_value -9999\n");
    for (int row = CELLS - 1; row >= 0; row--) {
      for (int column = 0; column < CELLS; column++) {
        text.append(600.0 + 7.0 * row + 3.0 * column).append(' ');
      }
      text.append('\n');
    }
    grid = HeightGrid.read(Files.writeString(folder.resolve("ground.asc"), text));
    map = new GroundMap(Optional.of(grid));
    plane = at(SOUTH_DEG + 0.5 * CELLS * CELL_DEG);
  }

  private static PlanningPlane at(double latitudeDeg) {
    return PlanningPlane.at(
        new StateInformation()
            .referenceFrame(ReferenceFrame.GLOBAL)
            .x(WEST_DEG + 0.5 * CELLS * CELL_DEG)
            .y(latitudeDeg)
            .z(700.0)
            .psi(0.0));
  }

  private double exactM(PlanningPlane on, double northM, double eastM) {
    Point place = on.point(northM, eastM, 0.0);
    return place.z() - grid.altitudeM(new Geodetic(place.x(), place.y(), 0.0)).orElseThrow();
  }

  /** Also where nodes replace others, and when it comes back to them. */
  @Test
  void downM_anywhereOnTheMap_isThatOfTheMap() {
    for (int round = 0; round < 2; round++) {
      for (double north = -600.0; north < 600.0; north += 37.3) {
        for (double east = -400.0; east < 400.0; east += 23.9) {
          assertThat(map.downM(plane, north, east))
              .isCloseTo(exactM(plane, north, east), within(0.5));
        }
      }
    }
  }

  /** Places are interpolated, heights are not. */
  @Test
  void mappedM_anywhereOnTheMap_isThatOfTheMapExactly() {
    assertThat(map.isOn(plane)).isTrue();
    for (double north = -600.0; north < 600.0; north += 37.3) {
      for (double east = -400.0; east < 400.0; east += 23.9) {
        assertThat(map.mappedM(north, east)).isCloseTo(exactM(plane, north, east), within(0.001));
      }
    }
    assertThat(map.mappedM(5000.0, 0.0)).isNaN();
  }

  @Test
  void mappedM_acrossTheDateLine_isThatOfTheMap() throws IOException {
    String text = "ncols 2\nnrows 2\nxllcenter 179.99\nyllcenter 47\ncellsize 0.02\n";
    Path file = Files.writeString(folder.resolve("line.asc"), text + "0 100\n0 100\n");
    map = new GroundMap(Optional.of(HeightGrid.read(file)));
    plane =
        PlanningPlane.at(
            new StateInformation()
                .referenceFrame(ReferenceFrame.GLOBAL)
                .x(180.0)
                .y(47.01)
                .z(700.0)
                .psi(0.0));

    assertThat(map.isOn(plane)).isTrue();
    assertThat(map.mappedM(1.0, 1.0)).isCloseTo(650.0, within(0.5));
    assertThat(map.mappedM(1.0, -1.0)).isCloseTo(650.0, within(0.5));
  }

  @Test
  void downM_otherPlane_isThatOfTheMapThere() {
    PlanningPlane other = at(SOUTH_DEG + 0.3 * CELLS * CELL_DEG);
    map.downM(plane, 5.0, 5.0);

    assertThat(map.downM(other, 5.0, 5.0)).isCloseTo(exactM(other, 5.0, 5.0), within(0.5));
  }

  @Test
  void downM_beyondTheMapOrWithoutOne_isUnknown() {
    assertThat(map.downM(plane, 5000.0, 0.0)).isNaN();
    assertThat(new GroundMap(Optional.empty()).downM(plane, 0.0, 0.0)).isNaN();
  }
}
