package org.u2sa.world.grid;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/** Beams in cells: ends, ways, tilt, motion, gaps. */
class ScanEntryTest {
  private static final double CELL = 0.1;

  private final GridWindow window = new GridWindow(CELL, 300);
  private final ScanEntry entry = new ScanEntry(window, new LogOdds(0.85, 0.4, -2.0, 3.5));
  private ScanEntry.Band band = new ScanEntry.Band(-0.2, 2.0, 1_000.0);

  private static StateInformation vehicle(double x, double y, double psi) {
    return new StateInformation().referenceFrame(ReferenceFrame.LOCAL_NED).x(x).y(y).psi(psi);
  }

  private static RangeScan scan(double start, double step, double... ranges) {
    List<OptionalDouble> list = new ArrayList<>();
    for (double range : ranges) {
      list.add(Double.isNaN(range) ? OptionalDouble.empty() : OptionalDouble.of(range));
    }
    return new RangeScan()
        .sensorName("laser")
        .minRange(0.1)
        .maxRange(10.0)
        .beams(start, step, list);
  }

  private OccupancyGrid enter(RangeScan scan, StateInformation vehicle) {
    window.centre(vehicle.x().orElseThrow(), vehicle.y().orElseThrow());
    Sighting sighting = new Sighting(0L, MapFrame.of(vehicle), Optional.of(vehicle));
    entry.enter(scan, ScanPoses.still(sighting), band, -1.0);
    return window.message(MapFrame.of(vehicle));
  }

  private static byte at(OccupancyGrid grid, double x, double y) {
    return grid.cellAt(Point.of(x, y, 0.0));
  }

  @Test
  void enter_beamsToAWall_endsAreOccupiedTheWayFreeTheRestUnknown() {
    double[] wall = new double[101];
    for (int i = 0; i < wall.length; i++) {
      wall[i] = 5.05 / Math.cos(-0.5 + 0.01 * i);
    }
    // The vehicle looks east: LOCAL_NED's y.
    OccupancyGrid grid = enter(scan(-0.5, 0.01, wall), vehicle(2.0, 3.0, Math.PI / 2.0));

    assertThat(at(grid, 2.03, 8.08)).isEqualTo((byte) 17); // 0.85 / 0.05, once for all beams
    assertThat(at(grid, 2.0, 7.5)).isEqualTo((byte) -8);
    assertThat(at(grid, 2.0, 3.5)).isEqualTo((byte) -8); // crossed by many beams, taken once
    assertThat(at(grid, 2.0, 8.3)).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(at(grid, 2.0, 2.5)).isEqualTo(OccupancyGrid.UNKNOWN); // behind the vehicle
    assertThat(at(grid, 5.0, 3.5)).isEqualTo(OccupancyGrid.UNKNOWN); // beside the field of view
  }

  @Test
  void enter_beamsToTheLeft_areNorthOfAVehicleThatLooksEast() {
    OccupancyGrid grid =
        enter(scan(Math.PI / 2.0 - 0.01, 0.01, 4.0, 4.0, 4.0), vehicle(0.0, 0.0, Math.PI / 2.0));

    assertThat(at(grid, 4.0, 0.0)).isGreaterThan((byte) 0);
    assertThat(at(grid, -4.0, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);
  }

  @Test
  void enter_noEcho_clearsAsFarAsTheScannerHasSeenOrAsConfigured() {
    double none = Double.NaN;
    RangeScan nothing = scan(-0.02, 0.01, none, none, none, none);
    OccupancyGrid grid = enter(nothing, vehicle(0.0, 0.0, 0.0));
    assertThat(at(grid, 1.0, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN); // may be covered or blind

    enter(scan(2.0, 0.01, 8.0), vehicle(0.0, 0.0, 0.0));
    OccupancyGrid far = enter(nothing, vehicle(0.0, 0.0, 0.0));
    assertThat(at(far, 7.7, 0.0)).isEqualTo((byte) -8);
    assertThat(at(far, 8.2, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);

    window.clear();
    band = new ScanEntry.Band(-0.2, 2.0, 3.0);
    OccupancyGrid near = enter(nothing, vehicle(0.0, 0.0, 0.0));
    assertThat(at(near, 2.9, 0.0)).isEqualTo((byte) -8);
    assertThat(at(near, 3.2, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);
  }

  @Test
  void enter_droppedBeamBetweenEchoes_doesNotClearBehindThem() {
    enter(scan(0.0, 0.02, 9.0), vehicle(0.0, 0.0, 0.0)); // something behind the wall to come
    RangeScan dropped = scan(-0.04, 0.02, 5.0, 5.0, Double.NaN, 5.0, 5.0);
    for (int n = 0; n < 20; n++) {
      enter(dropped, vehicle(0.0, 0.0, 0.0));
    }

    OccupancyGrid grid = enter(dropped, vehicle(0.0, 0.0, 0.0));
    assertThat(at(grid, 9.0, 0.0)).isGreaterThan((byte) 0);
    assertThat(at(grid, 4.5, 0.0)).isLessThan((byte) 0);
  }

  @Test
  void enter_echoOfTheVehicleItself_saysNothingOfTheDirection() {
    OccupancyGrid grid = enter(scan(-0.02, 0.01, 0.05, 0.05, 0.05, 0.05), vehicle(0.0, 0.0, 0.0));

    assertThat(at(grid, 0.05, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(at(grid, 1.0, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);
  }

  @Test
  void enter_wallSeenAtAGrazingAngle_isNotClearedByBeamsBeside() {
    int beams = 900;
    double[] ranges = new double[beams]; // a wall 0.5 m to the left, along the vehicle's way
    for (int i = 0; i < beams; i++) {
      double angle = 0.05 + i * 0.001;
      ranges[i] = 0.53 / Math.sin(angle);
    }
    OccupancyGrid grid = null;
    for (int n = 0; n < 20; n++) {
      grid = enter(scan(0.05, 0.001, ranges), vehicle(0.0, 0.0, 0.0));
    }

    for (double x = 0.75; x < 6.0; x += 0.1) { // LOCAL_NED: left of north is west
      assertThat(at(grid, x, -0.53)).as("wall at %s m", x).isGreaterThan((byte) 60);
      assertThat(at(grid, x, -0.33)).as("way at %s m", x).isLessThan((byte) 0);
    }
  }

  @Test
  void enter_tiltedDown_groundIsNoObstacleAndWhatLiesBehindUnknown() {
    RangeScan down = scan(-0.02, 0.01, 4.0, 4.0, 4.0, 4.0).z(-0.6).theta(-0.25);
    OccupancyGrid grid = enter(down, vehicle(0.0, 0.0, 0.0));

    // 0.6 m above the reference point, the beam leaves the band at -0.2 m after 0.8/sin 0.25 m.
    double leaves = 0.8 / Math.tan(0.25);
    assertThat(at(grid, leaves - 0.15, 0.0)).isEqualTo((byte) -8);
    assertThat(at(grid, leaves + 0.15, 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);
    assertThat(at(grid, 4.0 * Math.cos(0.25), 0.0)).isEqualTo(OccupancyGrid.UNKNOWN);
  }

  @Test
  void enter_vehicleRolled_beamToTheHighSideIsShortenedByTheRoll() {
    StateInformation rolled = vehicle(0.0, 0.0, 0.0).phi(0.6); // right side down
    RangeScan left = scan(Math.PI / 2.0 - 0.01, 0.01, 3.0, 3.0, 3.0);
    OccupancyGrid grid = enter(left, rolled);

    assertThat(at(grid, 0.0, -3.0 * Math.cos(0.6))).isGreaterThan((byte) 0);
    assertThat(at(grid, 0.0, -3.0)).isEqualTo(OccupancyGrid.UNKNOWN);
  }

  @Test
  void enter_beamsFarApart_saysNothingOfTheSpaceBetween() {
    double[] sparse = {8.0, 8.0, 8.0};
    OccupancyGrid grid = enter(scan(-0.5, 0.5, sparse), vehicle(0.0, 0.0, 0.0));

    assertThat(at(grid, 6.0, 0.0)).isEqualTo((byte) -8);
    Point between = Point.polar(0.25, 0.0, 6.0);
    assertThat(at(grid, between.x(), between.y())).isEqualTo(OccupancyGrid.UNKNOWN);
  }

  @Test
  void enter_beamsFarApartBeyondTheWindow_freesOneCellOfEachRowOrColumnOnTheirWay() {
    double[] far = new double[36];
    Arrays.fill(far, 40.0);
    OccupancyGrid grid = enter(scan(0.01, Math.PI / 18.0, far).maxRange(50.0), vehicle(0, 0, 0));

    Set<Integer> expected = new HashSet<>();
    for (int beam = 0; beam < far.length; beam++) {
      double x = Math.cos(0.01 + beam * Math.PI / 18.0);
      double y = -Math.sin(0.01 + beam * Math.PI / 18.0); // LOCAL_NED's y is to the right
      double longer = Math.max(Math.abs(x), Math.abs(y));
      for (int cell = 10; cell < 150; cell++) { // from where the beams are more than a cell apart
        double way = (cell + 0.5) / longer;
        int column = 150 + (int) Math.floor(way * x);
        int row = 150 + (int) Math.floor(way * y);
        expected.add(300 * row + column);
      }
    }
    Set<Integer> free = new HashSet<>();
    for (int k = 0; k < 300 * 300; k++) {
      boolean isNear = Math.abs(k % 300 - 149.5) < 10.0 && Math.abs(k / 300 - 149.5) < 10.0;
      if (!isNear && grid.cell(k % 300, k / 300) != OccupancyGrid.UNKNOWN) {
        free.add(k);
      }
    }
    assertThat(free).isEqualTo(expected);
  }

  @Test
  void enter_somethingBeforeAWallIsGone_isClearedAlongSparseBeamsToo() {
    double[] wall = new double[41]; // beams 2 degrees apart, far further apart than a cell
    double step = Math.toRadians(2.0);
    for (int i = 0; i < wall.length; i++) {
      wall[i] = 9.0 / Math.cos((i - 20) * step);
    }
    double[] walker = wall.clone();
    for (int i = 18; i <= 22; i++) {
      walker[i] = 6.0;
    }
    for (int n = 0; n < 20; n++) {
      enter(scan(-20.0 * step, step, walker), vehicle(0.0, 0.0, 0.0));
    }
    assertThat(at(window.message(MapFrame.of(vehicle(0.0, 0.0, 0.0))), 6.0, 0.0))
        .isEqualTo((byte) 70);

    OccupancyGrid grid = null;
    for (int n = 0; n < 10; n++) { // 3.5 / 0.4 scans
      grid = enter(scan(-20.0 * step, step, wall), vehicle(0.0, 0.0, 0.0));
    }
    for (int i = 18; i <= 22; i++) {
      Point was = Point.polar((i - 20) * step, 0.0, 6.0);
      assertThat(at(grid, was.x(), was.y())).as("beam %s", i).isLessThan((byte) 0);
    }
    assertThat(at(grid, 9.0, 0.0)).isGreaterThan((byte) 0);
  }

  @Test
  void enter_moreScannersThanAVehicleHas_remembersOnlyTheNewest() {
    for (int n = 0; n < 1_000; n++) {
      enter(scan(0.0, 0.01, 5.0).sensorName("invented " + n), vehicle(0.0, 0.0, 0.0));
    }

    assertThat(entry.scanners()).isLessThanOrEqualTo(64);
  }

  @Test
  void enter_vehicleTurnsDuringTheScan_pointsAreWhereTheyWere() {
    int beams = 400; // 360° in 0.4 s while the vehicle turns by 0.4 rad
    double[] ranges = new double[beams];
    double step = 2.0 * Math.PI / beams;
    for (int i = 0; i < beams; i++) {
      double heading = -0.4 * i / beams; // to the left positive
      double angle = -Math.PI + i * step + heading;
      ranges[i] = 4.0 / Math.max(Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle)));
    }
    StateInformation before = vehicle(0.0, 0.0, 0.0);
    Sighting first = new Sighting(0L, MapFrame.of(before), Optional.of(before));
    window.centre(0.0, 0.0);
    RangeScan scan = scan(-Math.PI, step, ranges);
    entry.enter(scan, new ScanPoses(first, Optional.of(vehicle(0.0, 0.0, 0.4))), band, -1.0);

    byte[] cells = window.cells();
    int wrong = 0;
    int hits = 0;
    for (int row = 0; row < 300; row++) {
      for (int column = 0; column < 300; column++) {
        if (cells[row * 300 + column] > 0) {
          double x = (column + 0.5) * CELL - 15.0;
          double y = (row + 0.5) * CELL - 15.0;
          hits++;
          wrong += Math.abs(Math.max(Math.abs(x), Math.abs(y)) - 4.0) > 0.25 ? 1 : 0;
        }
      }
    }
    assertThat(hits).isGreaterThan(150);
    assertThat(wrong).isZero();
  }

  @Test
  void centre_vehicleMoves_cellsStayWhereTheyAreInTheWorld() {
    Random random = new Random(2L);
    window.centre(0.0, 0.0);
    window.cells()[150 * 300 + 160] = 42;
    double x = 1.05; // of that cell's middle
    double y = 0.05;
    for (int i = 0; i < 50; i++) {
      window.centre(10.0 * random.nextDouble() - 5.0, 10.0 * random.nextDouble() - 5.0);
      assertThat(at(window.message(MapFrame.of(vehicle(0.0, 0.0, 0.0))), x, y))
          .isEqualTo((byte) 42);
    }
    window.centre(100.0, 0.0);
    window.centre(0.0, 0.0);
    assertThat(at(window.message(MapFrame.of(vehicle(0.0, 0.0, 0.0))), x, y))
        .isEqualTo(OccupancyGrid.UNKNOWN);
  }
}
