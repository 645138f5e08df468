import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Random;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.hybrid.HybridAStar;
import org.u2sa.planning.search.BodyDiscs;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.DStarLite;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.GridPath;
import org.u2sa.planning.search.Inflation;

/** CPU time of planning: repairing a route after a local change, and hybrid A* from scratch. */
public final class Planning {
  private static final ThreadMXBean CPU = ManagementFactory.getThreadMXBean();
  private static final double CELL_M = 0.1;

  private Planning() {}

  public static void main(String[] arguments) {
    Bench.printMachine("Planning, CPU time");
    repair();
    hybrid(0.1, OptionalDouble.empty());
    hybrid(0.2, OptionalDouble.empty());
    hybrid(0.15, OptionalDouble.of(1.0));
  }

  private static void repair() {
    int cells = 1000;
    GridFrame frame = new GridFrame(0.0, 0.0, CELL_M, cells, cells);
    boolean[] occupied = discs(new Random(5), cells, 0.2, 3, 17, 40);
    CostGrid costs = new CostGrid(frame, new Inflation(0.5, 1.3, 3.0));
    long start = CPU.getCurrentThreadCpuTime();
    costs.update(i -> occupied[i], i -> false);
    double costsMs = ms(start);
    DStarLite search = new DStarLite(costs, 95.0, 95.0);
    start = CPU.getCurrentThreadCpuTime();
    GridPath path = search.plan(frame.indexAt(5.0, 5.0)).orElseThrow();
    System.out.printf(Locale.ROOT, "D* Lite 1000 x 1000: costs %.1f ms, first route %.1f ms%n", costsMs, ms(start));
    double[] times = new double[200];
    for (int k = 0; k < times.length; k++) {
      double[] ahead = along(path.corners(), 3.0);
      int row = frame.row(ahead[0]);
      int column = frame.column(ahead[1]);
      CostGrid.Area area =
          new CostGrid.Area(row - 3, column - 3, Math.min(cells - 1, row + 3), Math.min(cells - 1, column + 3));
      double[] next = along(path.corners(), 0.3);
      start = CPU.getCurrentThreadCpuTime();
      costs.update(i -> occupied[i] || isIn(area, i / cells, i % cells), i -> false);
      path = search.plan(costs.nearestFree(next[0], next[1], 2.0)).orElseThrow();
      times[k] = ms(start);
    }
    print("D* Lite 1000 x 1000, repaired", times);
  }

  private static boolean isIn(CostGrid.Area area, int row, int column) {
    return row >= area.firstRow() && row <= area.lastRow() && column >= area.firstColumn() && column <= area.lastColumn();
  }

  private static void hybrid(double density, OptionalDouble heading) {
    int cells = 384;
    HybridAStar search = new HybridAStar();
    double[] times = new double[100];
    for (int k = -20; k < times.length; k++) { // the first ones warm up
      boolean[] occupied = discs(new Random(k), cells, density, 4, 14, 26);
      CostGrid costs = new CostGrid(new GridFrame(0.0, 0.0, CELL_M, cells, cells), new Inflation(0.45, 1.5, 3.0));
      costs.update(i -> occupied[i], i -> false);
      long start = CPU.getCurrentThreadCpuTime();
      search.plan(
          costs,
          new BodyDiscs(0.6, 0.2, 0.5),
          0.1,
          HybridAStar.Motion.of(1.0, true),
          new Pose(3.0, 3.0, 0.0),
          new HybridAStar.Goal(35.0, 35.0, heading, 0.2));
      if (k >= 0) {
        times[k] = ms(start);
      }
    }
    print(
        String.format(Locale.ROOT, "hybrid A* 384 x 384, %.0f %% covered%s", 100.0 * density, heading.isPresent() ? ", with heading" : ""),
        times);
  }

  private static boolean[] discs(Random random, int cells, double density, int least, int most, int freeCells) {
    boolean[] occupied = new boolean[cells * cells];
    double covered = 0.0;
    while (covered < density) {
      int row = random.nextInt(cells);
      int column = random.nextInt(cells);
      int radius = least + random.nextInt(most - least);
      boolean keptFree =
          Math.hypot(row - 30, column - 30) < radius + freeCells
              || Math.hypot(row - 50, column - 50) < radius + freeCells
              || Math.hypot(row - cells + 34, column - cells + 34) < radius + freeCells
              || Math.hypot(row - cells + 50, column - cells + 50) < radius + freeCells;
      for (int r = Math.max(0, row - radius); !keptFree && r <= Math.min(cells - 1, row + radius); r++) {
        for (int c = Math.max(0, column - radius); c <= Math.min(cells - 1, column + radius); c++) {
          if (!occupied[r * cells + c] && Math.hypot(r - row, c - column) <= radius) {
            occupied[r * cells + c] = true;
            covered += 1.0 / (cells * cells);
          }
        }
      }
    }
    return occupied;
  }

  private static double[] along(List<GridPath.Corner> corners, double metres) {
    double left = metres;
    double north = corners.get(0).northM();
    double east = corners.get(0).eastM();
    for (GridPath.Corner corner : corners.subList(1, corners.size())) {
      double length = Math.hypot(corner.northM() - north, corner.eastM() - east);
      if (length >= left) {
        double share = left / length;
        return new double[] {north + share * (corner.northM() - north), east + share * (corner.eastM() - east)};
      }
      left -= length;
      north = corner.northM();
      east = corner.eastM();
    }
    return new double[] {north, east};
  }

  private static double ms(long start) {
    return (CPU.getCurrentThreadCpuTime() - start) / 1e6;
  }

  private static void print(String what, double[] times) {
    Arrays.sort(times);
    System.out.printf(
        Locale.ROOT,
        "%s: median %.1f ms, 90 %% %.1f ms, longest %.1f ms%n",
        what,
        times[times.length / 2],
        times[times.length * 9 / 10],
        times[times.length - 1]);
  }
}
