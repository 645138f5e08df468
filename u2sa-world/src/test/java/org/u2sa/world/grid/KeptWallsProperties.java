package org.u2sa.world.grid;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * What stands stays on the grid, at whatever angle and with whatever beams it is seen, if places
 * and ranges are exact.
 */
class KeptWallsProperties {
  private static final double CELL = 0.1;
  private static final double REACH = 30.0;
  private static final int SCANS = 60;

  /** A wall from one corner to another [m]. */
  private record Wall(double x0, double y0, double x1, double y1) {
    /** Where a ray meets the wall [m]; beyond all reach if it does not. */
    double meets(double x, double y, double cos, double sin) {
      double alongX = x1 - x0;
      double alongY = y1 - y0;
      double cross = cos * alongY - sin * alongX;
      double range = ((x0 - x) * alongY - (y0 - y) * alongX) / cross;
      double share = ((x0 - x) * sin - (y0 - y) * cos) / cross;
      return range > 0.0 && share >= 0.0 && share <= 1.0 ? range : Double.POSITIVE_INFINITY;
    }

    double distance(double x, double y) {
      double share =
          ((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / (square(x1 - x0) + square(y1 - y0));
      double nearest = Math.max(0.0, Math.min(1.0, share));
      return Math.hypot(x0 + nearest * (x1 - x0) - x, y0 + nearest * (y1 - y0) - y);
    }

    private static double square(double value) {
      return value * value;
    }
  }

  private final GridWindow window = new GridWindow(CELL, 800);
  private final ScanEntry entry = new ScanEntry(window, new LogOdds(0.85, 0.4, -2.0, 3.5));
  private final Set<Integer> seen = new HashSet<>(); // cells in which a beam ended

  private void begin() {
    window.clear();
    window.move(-400, -400);
    seen.clear();
  }

  private void look(List<Wall> walls, double x, double y, double psi, double stepDeg) {
    double step = Math.toRadians(stepDeg);
    List<OptionalDouble> ranges = new ArrayList<>();
    for (int i = 0; i < 180.0 / stepDeg; i++) {
      double angle = psi - Math.PI / 2.0 + i * step;
      double cos = Math.cos(angle);
      double sin = Math.sin(angle);
      double range = Double.POSITIVE_INFINITY;
      for (Wall wall : walls) {
        range = Math.min(range, wall.meets(x, y, cos, sin));
      }
      boolean echo = range <= REACH;
      ranges.add(echo ? OptionalDouble.of(range) : OptionalDouble.empty());
      if (echo) {
        int column = (int) window.column(x + range * cos);
        seen.add((int) window.row(y + range * sin) * window.side() + column);
      }
    }
    StateInformation vehicle =
        new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU).x(x).y(y).psi(psi);
    RangeScan scan =
        new RangeScan().sensorName("laser").maxRange(REACH).beams(-Math.PI / 2.0, step, ranges);
    Sighting sighting = new Sighting(0L, MapFrame.of(vehicle), Optional.of(vehicle));
    entry.enter(scan, ScanPoses.still(sighting), new ScanEntry.Band(-0.2, 2.0, 1_000.0), 1.0);
  }

  /** A wall 0.3 m thick, from all sides. */
  private static List<Wall> box(double x, double y, double way, double length) {
    double alongX = length * Math.cos(way);
    double alongY = length * Math.sin(way);
    double asideX = -0.3 * Math.sin(way);
    double asideY = 0.3 * Math.cos(way);
    return List.of(
        new Wall(x, y, x + alongX, y + alongY),
        new Wall(x + alongX, y + alongY, x + alongX + asideX, y + alongY + asideY),
        new Wall(x + alongX + asideX, y + alongY + asideY, x + asideX, y + asideY),
        new Wall(x + asideX, y + asideY, x, y));
  }

  private static boolean isClearOfPath(Wall wall) {
    return IntStream.range(0, SCANS).allMatch(i -> wall.distance(pathX(i), pathY(i)) > 0.5);
  }

  private static double pathX(int i) {
    return 0.2 * i - 6.0;
  }

  private static double pathY(int i) {
    return 2.0 * Math.sin(0.2 * i);
  }

  /** Share of the cells with echoes that are occupied, or beside one that is. */
  private double kept(int beside) {
    return seen.stream().filter(cell -> isOccupied(cell, beside)).count()
        / (double) Math.max(1, seen.size());
  }

  private boolean isOccupied(int cell, int beside) {
    boolean occupied = false;
    for (int row = -beside; row <= beside; row++) {
      for (int column = -beside; column <= beside; column++) {
        occupied |= window.cells()[cell + row * window.side() + column] > 0;
      }
    }
    return occupied;
  }

  @Example
  void enter_straightCorridorBeamsOfTwoDegrees_allCellsWithEchoesStayOccupied() {
    begin();
    List<Wall> corridor =
        List.of(new Wall(-35.0, -1.23, 35.0, -1.23), new Wall(-35.0, 1.17, 35.0, 1.17));
    for (int i = 0; i < SCANS; i++) {
      look(corridor, -15.0 + 0.5 * i, 0.0, 0.0, 2.0);
    }

    assertThat(kept(0)).isGreaterThanOrEqualTo(0.99);
  }

  @Property(tries = 40, seed = "28")
  void enter_wallsAtRandom_almostAllCellsWithEchoesStayOccupied(
      @ForAll long seed, @ForAll @DoubleRange(min = 0.25, max = 4.0) double stepDeg) {
    begin();
    Random random = new Random(seed);
    List<Wall> walls = new ArrayList<>();
    while (walls.size() < 4 * 8) {
      double x = 30.0 * random.nextDouble() - 15.0;
      double y = 30.0 * random.nextDouble() - 15.0;
      double way = 2.0 * Math.PI * random.nextDouble();
      double length = 2.0 + 20.0 * random.nextDouble();
      List<Wall> box = box(x, y, way, length);
      if (box.stream().allMatch(KeptWallsProperties::isClearOfPath)) {
        walls.addAll(box);
      }
    }
    for (int i = 0; i < SCANS; i++) {
      look(walls, pathX(i), pathY(i), 0.3 * i, stepDeg);
    }

    assertThat(kept(1)).isGreaterThanOrEqualTo(seen.isEmpty() ? 0.0 : 0.99);
  }
}
