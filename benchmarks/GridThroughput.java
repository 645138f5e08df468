package org.u2sa.world.grid;

import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Lidar points a second that one thread enters into the occupancy grid, clearing included: scans as
 * they come from the wire, each with a pose of its own, a window that rolls. Run by benchmarks/run
 * with U2SA_BENCHMARKS=org.u2sa.world.GridThroughput.
 */
final class GridThroughput {
  private static final int SCANS = 200;
  private static final int ROUNDS = 7;
  private static final double ROUND_S = 0.5;

  private record Lidar(String name, int beams, double fieldDeg, double reach, double cell) {}

  public static void main(String[] arguments) {
    System.out.println(
        "| scanner | room | cell | points/s, median of "
            + ROUNDS
            + " | slowest | fastest | µs a scan |\n|---|---|---|---|---|---|---|");
    for (Lidar lidar :
        List.of(
            new Lidar("1081 beams, 270°, 10 m", 1081, 270.0, 10.0, 0.1),
            new Lidar("1081 beams, 270°, 10 m", 1081, 270.0, 10.0, 0.05),
            new Lidar("1081 beams, 270°, 30 m", 1081, 270.0, 30.0, 0.1),
            new Lidar("541 beams, 270°, 20 m", 541, 270.0, 20.0, 0.05),
            new Lidar("360 beams, 360°, 12 m", 360, 360.0, 12.0, 0.1))) {
      for (double room : new double[] {6.0, 20.0}) {
        measure(lidar, room);
      }
    }
  }

  private static void measure(Lidar lidar, double room) {
    List<RangeScan> scans = scans(lidar, room);
    GridWindow window = new GridWindow(lidar.cell(), (int) Math.round(60.0 / lidar.cell()));
    ScanEntry entry = new ScanEntry(window, new LogOdds(0.85, 0.4, -2.0, 3.5));
    ScanEntry.Band band = new ScanEntry.Band(-1.0, 2.0, 1_000.0);
    double[] rates = new double[ROUNDS];
    for (int round = -3; round < ROUNDS; round++) { // the first are for the compiler
      long points = 0;
      int at = 0;
      long began = cpuNanos();
      while (cpuNanos() - began < ROUND_S * 1e9) {
        for (int i = 0; i < 50; i++) {
          StateInformation vehicle = vehicle(at);
          Sighting sighting =
              new Sighting(0L, MapFrame.of(vehicle), Optional.of(vehicle));
          points += entry.enter(scans.get(at++ % SCANS), ScanPoses.still(sighting), band, -1.0);
        }
      }
      if (round >= 0) {
        rates[round] = points / ((cpuNanos() - began) / 1e9);
      }
    }
    Arrays.sort(rates);
    double median = rates[ROUNDS / 2];
    System.out.printf(
        "| %s | %.0f m | %.2f m | %.1f M | %.1f M | %.1f M | %.0f |%n",
        lidar.name(),
        room,
        lidar.cell(),
        median / 1e6,
        rates[0] / 1e6,
        rates[ROUNDS - 1] / 1e6,
        lidar.beams() / median * 1e6);
  }

  /** Processor time of this thread: other work on the machine does not count. */
  private static long cpuNanos() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  private static StateInformation vehicle(int i) {
    double way = i % 1_000 / 1_000.0;
    return new StateInformation()
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(way)
        .y(0.3 * way)
        .psi(6.0 * way);
  }

  /** A square room with pillars, seen with 3 cm of noise; what is out of reach gives no echo. */
  private static List<RangeScan> scans(Lidar lidar, double room) {
    Random random = new Random(5L);
    double[][] pillars = new double[8][];
    for (int i = 0; i < pillars.length; i++) {
      double angle = random.nextDouble() * 2.0 * Math.PI;
      double range = room * (0.2 + 0.25 * random.nextDouble());
      pillars[i] = new double[] {range * Math.cos(angle), range * Math.sin(angle), 0.2};
    }
    List<RangeScan> scans = new ArrayList<>();
    double start = -Math.toRadians(lidar.fieldDeg()) / 2.0;
    double step = Math.toRadians(lidar.fieldDeg()) / (lidar.beams() - 1.0);
    for (int n = 0; n < SCANS; n++) {
      double turn = n * 2.0 * Math.PI / SCANS;
      List<OptionalDouble> ranges = new ArrayList<>();
      for (int i = 0; i < lidar.beams(); i++) {
        double range = distance(pillars, room, turn + start + i * step) + 0.03 * random.nextGaussian();
        ranges.add(range <= lidar.reach() ? OptionalDouble.of(range) : OptionalDouble.empty());
      }
      RangeScan scan =
          new RangeScan()
              .sensorName("laser")
              .minRange(0.06)
              .maxRange(lidar.reach())
              .beams(start, step, ranges);
      scan.freeze();
      scans.add(scan);
    }
    return scans;
  }

  private static double distance(double[][] pillars, double room, double angle) {
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    double nearest = room / 2.0 / Math.max(Math.abs(cos), Math.abs(sin));
    for (double[] pillar : pillars) {
      double along = pillar[0] * cos + pillar[1] * sin;
      double off = pillar[1] * cos - pillar[0] * sin;
      if (along > 0.0 && Math.abs(off) < pillar[2]) {
        nearest = Math.min(nearest, along - Math.sqrt(pillar[2] * pillar[2] - off * off));
      }
    }
    return nearest;
  }
}
