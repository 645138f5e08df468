package org.u2sa.world.scanmap;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.zip.GZIPInputStream;
import org.u2sa.estimation.EstimateWriter;
import org.u2sa.estimation.LocalOdometry;
import org.u2sa.estimation.fusion.ErrorStateFilter;
import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.estimation.fusion.FilterTuning;
import org.u2sa.estimation.fusion.MotionDomain;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.MeasurementReader;
import org.u2sa.estimation.measurement.UsualSigmas;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.grid.GridModeller;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.Sighting;

/**
 * Drives a published CARMEN lidar log on odometry that drifts through the State Estimator's filter
 * and the World Modeler's scan map, and compares both with the log's corrected poses: {@code java
 * … CarmenDrift csail-corrected.log.gz [raw log]}. With a raw log, the odometry is that of its
 * robot, and its scans are compared wherever the corrected log has the same one. Without, wheels
 * are made of the corrected poses, with errors of scale, of heading per metre and of each step, by a
 * seed. System properties: {@code map} false leaves the scan map out; {@code seed}; {@code loops}
 * false closes none; {@code cell} side of a cell [m]; {@code trace} file for all poses.
 */
final class CarmenDrift {
  private static final double REACH = 40.0; // larger values are the scanner's "nothing"
  private static final double SPEED = 0.5; // of made wheels [m/s]
  private static final double TURN = 0.5; // [rad/s]
  private static final double PERIOD_S = 0.1;

  private record Shot(double[] ranges, Pose2 pose, Pose2 odometry) {}

  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private final MeasurementReader reader = new MeasurementReader(new UsualSigmas(3.0, 0.3, 0.05, 0.015, 0.35, 1.0));
  private final Measurement measurement = new Measurement();
  private final LocalOdometry local = new LocalOdometry();
  private final GridModeller grid;
  private final ScanMapModeller map;
  private final boolean isMapped = Boolean.parseBoolean(System.getProperty("map", "true"));
  private final List<Integer> byKey = new ArrayList<>(); // newest key scan at each scan
  private final List<Pose2> fromKey = new ArrayList<>(); // pose of each scan relative to it
  private MapFrame frame;
  private long micros = 1_000_000L;
  private double scanSeconds;
  private Pose2 located; // of the newest scan, in the map's axes: north, east, clockwise

  private CarmenDrift(double cell, double side) {
    XmlConfiguration configuration =
        XmlConfiguration.inMemory(
            "benchmark",
            Map.of(
                "CELL SIZE", cell,
                "GRID SIZE", side,
                "MATCH POINTS", Integer.getInteger("points", 400),
                "MIN SHARE", Double.parseDouble(System.getProperty("share", "0.3")),
                "CLOSE LOOPS", Boolean.parseBoolean(System.getProperty("loops", "true"))));
    grid = new GridModeller(configuration);
    map = new ScanMapModeller(configuration, grid, Path::of, true, true);
  }

  public static void main(String[] arguments) throws IOException {
    List<Shot> corrected = read(Path.of(arguments[0]));
    boolean isRaw = arguments.length > 1;
    List<Shot> driven = isRaw ? read(Path.of(arguments[1])) : corrected;
    Map<Integer, Pose2> truth = new HashMap<>();
    Map<Integer, Integer> byRanges = new HashMap<>();
    for (int i = 0; i < corrected.size(); i++) {
      byRanges.put(Arrays.hashCode(corrected.get(i).ranges()), i);
    }
    for (int i = 0; i < driven.size(); i++) {
      Integer same = byRanges.get(Arrays.hashCode(driven.get(i).ranges()));
      if (same != null) {
        truth.put(i, corrected.get(same).pose());
      }
    }
    int first = truth.keySet().stream().min(Integer::compare).orElseThrow();
    double extent = 0.0;
    for (Pose2 each : truth.values()) {
      extent = Math.max(extent, Math.max(Math.abs(each.x()), Math.abs(each.y())));
    }
    double side = 2.0 * (extent + REACH + 10.0);
    double cell = Double.parseDouble(System.getProperty("cell", "0.05"));
    while (side / cell > 4096) {
      cell *= 2.0;
    }
    CarmenDrift drift = new CarmenDrift(cell, side);
    drift.run(driven, first, truth, isRaw, arguments[0]);
  }

  private void run(
      List<Shot> shots, int first, Map<Integer, Pose2> truth, boolean isRaw, String name)
      throws IOException {
    Random random = new Random(Long.getLong("seed", 1L) * 1000003L + shots.size());
    double scale = isRaw ? 1.0 : 1.0 + 0.02 * random.nextGaussian();
    double bend = isRaw ? 0.0 : Math.toRadians(0.25) * random.nextGaussian(); // per metre
    Pose2 start = truth.get(first);
    add(state("Start", ReferenceFrame.LOCAL_ENU).x(start.x()).y(start.y()).psi(start.theta()), 0.02);
    Pose2 odometry = start;
    List<Pose2> states = new ArrayList<>();
    List<Pose2> dead = new ArrayList<>();
    List<double[]> sigmas = new ArrayList<>();
    long[] stamps = new long[shots.size()];
    for (int i = first; i < shots.size(); i++) {
      if (i > first) {
        Pose2 step = shots.get(i).odometry().from(shots.get(i - 1).odometry());
        double way = Math.hypot(step.x(), step.y());
        if (!isRaw) {
          double turn =
              step.theta() * (1.0 + 0.03 * random.nextGaussian())
                  + bend * way
                  + Math.toRadians(0.6) * Math.sqrt(way) * random.nextGaussian();
          double factor = scale + 0.02 * random.nextGaussian();
          step = new Pose2(step.x() * factor, step.y() * factor, turn);
        }
        odometry = odometry.times(step);
        drive(step);
      }
      stamps[i] = micros;
      Estimate estimate = filter.at(micros);
      scan(shots.get(i), EstimateWriter.write(estimate));
      if (isMapped) {
        int key = map.keys().size() - 1;
        byKey.add(key);
        fromKey.add(located.from(map.keys().get(key).pose()));
      }
      estimate = filter.at(micros);
      states.add(new Pose2(estimate.localM(1), estimate.localM(0), Math.PI / 2 - estimate.psi()));
      sigmas.add(
          new double[] {
            estimate.positionSigmaM(1), estimate.positionSigmaM(0), estimate.attitudeSigma(2)
          });
      dead.add(odometry);
    }
    report(shots, first, truth, states, dead, sigmas, stamps, name);
  }

  private static StateInformation state(String source, ReferenceFrame axes) {
    return new StateInformation().sensorName(source).referenceFrame(axes);
  }

  private void add(StateInformation message, double sigma) {
    message.xSigma(sigma).ySigma(sigma).psiSigma(sigma);
    message.timestamp(micros);
    filter.add(reader.read(message, measurement));
  }

  /** Turns, goes straight, and turns again, at the wheels' pace. */
  private void drive(Pose2 step) {
    double way = Math.hypot(step.x(), step.y());
    double first = way < 1e-4 ? 0.0 : Math.atan2(step.y(), step.x());
    boolean back = Math.abs(first) > Math.PI / 2;
    double turn = way < 0.02 ? 0.0 : back ? Pose2.wrapped(first + Math.PI) : first;
    wheels(0.0, turn);
    wheels(back ? -way : way, 0.0);
    wheels(0.0, Pose2.wrapped(step.theta() - turn));
    wheel(0.0, 0.0, 10_000L); // a scan never has the time of the one before
  }

  private void wheels(double way, double turn) {
    double seconds = Math.max(Math.abs(way) / SPEED, Math.abs(turn) / TURN);
    int parts = (int) Math.ceil(seconds / PERIOD_S);
    for (int i = 0; i < parts; i++) {
      long step = Math.max(1_000L, Math.round(seconds / parts * 1e6));
      wheel(way / parts / (step * 1e-6), turn / parts / (step * 1e-6), step);
    }
  }

  private void wheel(double speed, double rate, long step) {
    StateInformation wheels = state("Wheels", ReferenceFrame.BODY_FLU).xDot(speed).psiDot(rate);
    wheels.xDotSigma(0.02 + 0.1 * Math.abs(speed)).psiDotSigma(0.02 + 0.1 * Math.abs(rate));
    wheels.timestamp(micros);
    filter.add(reader.read(wheels, measurement));
    micros += step;
    Estimate estimate = filter.at(micros);
    local.moveTo(estimate);
    map.local(local.write(estimate));
  }

  private void scan(Shot shot, StateInformation state) {
    int beams = shot.ranges().length;
    double step = Math.PI / (beams % 2 == 1 ? beams - 1 : beams);
    List<OptionalDouble> ranges = new ArrayList<>();
    for (double range : shot.ranges()) {
      ranges.add(range < REACH ? OptionalDouble.of(range) : OptionalDouble.empty());
    }
    RangeScan scan =
        new RangeScan().sensorName("FLASER").maxRange(REACH).beams(-Math.PI / 2.0, step, ranges);
    scan.timestamp(micros);
    state.timestamp(micros);
    if (frame == null) {
      frame = MapFrame.of(state);
      map.enter(frame, new Sighting(micros, frame, Optional.of(state)));
    }
    if (state.psi().isEmpty() || state.x().isEmpty()) {
      return; // lost, without a map
    }
    long began = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    ScanPoses poses = ScanPoses.still(new Sighting(micros, frame, Optional.of(state)));
    if (isMapped) {
      map.scan(scan, poses);
      located = plane(state);
      for (StateInformation each : map.corrections()) {
        located = plane(each);
        filter.add(reader.read(each, measurement));
      }
    } else {
      grid.scan(scan, poses);
    }
    scanSeconds += (ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - began) * 1e-9;
  }

  private static Pose2 plane(StateInformation state) {
    StateInformation ned = state.in(ReferenceFrame.LOCAL_NED);
    return new Pose2(
        ned.x().orElseThrow(), ned.y().orElseThrow(), Pose2.wrapped(ned.psi().orElseThrow()));
  }

  private void report(
      List<Shot> shots,
      int first,
      Map<Integer, Pose2> truth,
      List<Pose2> states,
      List<Pose2> dead,
      List<double[]> sigmas,
      long[] stamps,
      String name)
      throws IOException {
    Map<Long, Pose2> keys = new HashMap<>();
    if (isMapped) {
      for (KeyScan key : map.keys()) {
        Pose2 p = key.pose(); // north, east, clockwise
        keys.put(
            key.scan().timestamp().orElseThrow(), new Pose2(p.y(), p.x(), Math.PI / 2 - p.theta()));
      }
    }
    List<Pose2> true1 = new ArrayList<>();
    List<Pose2> state1 = new ArrayList<>();
    List<Pose2> dead1 = new ArrayList<>();
    List<Pose2> trueKeys = new ArrayList<>();
    List<Pose2> keys1 = new ArrayList<>();
    Map<Integer, Pose2> all = new HashMap<>();
    int inside = 0;
    List<String> trace = new ArrayList<>();
    for (int i = first; i < shots.size(); i++) {
      Pose2 state = states.get(i - first);
      Pose2 key = keys.get(stamps[i]);
      if (isMapped) {
        Pose2 p = map.keys().get(byKey.get(i - first)).pose().times(fromKey.get(i - first));
        all.put(i, new Pose2(p.y(), p.x(), Math.PI / 2 - p.theta()));
      } else {
        all.put(i, state);
      }
      Pose2 is = truth.get(i);
      if (is != null) {
        true1.add(is);
        state1.add(state);
        dead1.add(dead.get(i - first));
        double[] s = sigmas.get(i - first);
        double off = state.distance(is);
        inside += off < 3.0 * Math.hypot(s[0], s[1]) ? 1 : 0;
        Pose2 m = all.get(i);
        trace.add(
            String.format(Locale.ROOT, "%.3f %.3f %.4f %.4f %.4f", m.x(), m.y(), m.theta(), s[0], s[2]));
        if (key != null) {
          trueKeys.add(is);
          keys1.add(key);
        }
      }
    }
    double[] d = errors(dead1, true1, false);
    double[] s = errors(state1, true1, true);
    double[] u = errors(state1, true1, false);
    double[] k = keys1.isEmpty() ? new double[2] : errors(keys1, trueKeys, true);
    double[] kept = kept(shots, first, all);
    System.out.printf(
        Locale.ROOT,
        "%s: %d scans, %d judged; odometry mean %.2f max %.2f m; state mean %.3f max %.2f m aligned, "
            + "%.3f m from the start, %.0f %% within 3 sigma; map mean %.3f max %.2f m; "
            + "echoes kept %.1f %%; %.2f ms a scan; %s%n",
        Path.of(name).getFileName(),
        shots.size() - first,
        true1.size(),
        d[0],
        d[1],
        s[0],
        s[1],
        u[0],
        100.0 * inside / true1.size(),
        k[0],
        k[1],
        kept[0],
        1e3 * scanSeconds / (shots.size() - first),
        map.remark());
    if (System.getProperty("trace") != null) {
      List<String> lines = new ArrayList<>();
      for (int i = 0; i < true1.size(); i++) {
        lines.add(
            String.format(
                Locale.ROOT,
                "%.3f %.3f %.4f %.3f %.3f %.4f %s",
                true1.get(i).x(),
                true1.get(i).y(),
                true1.get(i).theta(),
                state1.get(i).x(),
                state1.get(i).y(),
                state1.get(i).theta(),
                trace.get(i)));
      }
      Files.write(Path.of(System.getProperty("trace")), lines);
    }
  }

  /** Mean and largest error of positions, after a rigid alignment by least squares if wanted. */
  private static double[] errors(List<Pose2> poses, List<Pose2> truth, boolean align) {
    double mx = 0.0;
    double my = 0.0;
    double tx = 0.0;
    double ty = 0.0;
    int n = poses.size();
    for (int i = 0; i < n; i++) {
      mx += poses.get(i).x() / n;
      my += poses.get(i).y() / n;
      tx += truth.get(i).x() / n;
      ty += truth.get(i).y() / n;
    }
    double sin = 0.0;
    double cos = 0.0;
    for (int i = 0; i < n; i++) {
      double ax = poses.get(i).x() - mx;
      double ay = poses.get(i).y() - my;
      double bx = truth.get(i).x() - tx;
      double by = truth.get(i).y() - ty;
      cos += ax * bx + ay * by;
      sin += ax * by - ay * bx;
    }
    double angle = align ? Math.atan2(sin, cos) : 0.0;
    double c = Math.cos(angle);
    double s = Math.sin(angle);
    double sum = 0.0;
    double largest = 0.0;
    for (int i = 0; i < n; i++) {
      double x = poses.get(i).x();
      double y = poses.get(i).y();
      double ex = align ? tx + c * (x - mx) - s * (y - my) : x;
      double ey = align ? ty + s * (x - mx) + c * (y - my) : y;
      double off = Math.hypot(ex - truth.get(i).x(), ey - truth.get(i).y());
      sum += off;
      largest = Math.max(largest, off);
    }
    return new double[] {sum / n, largest};
  }

  /** Share of echoes on or beside an occupied cell of the grid, from the poses that made it. */
  private double[] kept(List<Shot> shots, int first, Map<Integer, Pose2> poses) {
    Sighting now = new Sighting(micros, frame, Optional.empty());
    OccupancyGrid message = isMapped ? map.grid(now).orElseThrow() : grid.grid(now).orElseThrow();
    byte[] cells = message.cells();
    long echoes = 0;
    long kept = 0;
    for (int i = first; i < shots.size(); i++) {
      Pose2 pose = poses.get(i); // east, north
      double[] ranges = shots.get(i).ranges();
      double step = Math.PI / (ranges.length % 2 == 1 ? ranges.length - 1 : ranges.length);
      for (int b = 0; b < ranges.length; b++) {
        if (ranges[b] >= REACH || ranges[b] <= 0.0) {
          continue;
        }
        double angle = pose.theta() - Math.PI / 2 + b * step;
        double east = pose.x() + ranges[b] * Math.cos(angle);
        double north = pose.y() + ranges[b] * Math.sin(angle);
        boolean found = false;
        for (int r = -1; r <= 1; r++) {
          for (int c = -1; c <= 1; c++) {
            int column = (int) Math.floor((north - message.left()) / message.resolution()) + c;
            int row = (int) Math.floor((east - message.bottom()) / message.resolution()) + r;
            found |=
                column >= 0
                    && row >= 0
                    && column < message.columns()
                    && row < message.rows()
                    && cells[row * message.columns() + column] > 0;
          }
        }
        echoes++;
        kept += found ? 1 : 0;
      }
    }
    return new double[] {100.0 * kept / echoes};
  }

  private static List<Shot> read(Path log) throws IOException {
    List<Shot> shots = new ArrayList<>();
    try (InputStream file = Files.newInputStream(log);
        InputStream bytes = log.toString().endsWith(".gz") ? new GZIPInputStream(file) : file;
        BufferedReader in =
            new BufferedReader(new InputStreamReader(bytes, StandardCharsets.US_ASCII))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        if (!line.startsWith("FLASER ")) {
          continue;
        }
        String[] part = line.trim().split("\\s+");
        int beams = Integer.parseInt(part[1]);
        double[] numbers = new double[beams + 6];
        for (int i = 0; i < numbers.length; i++) {
          numbers[i] = Double.parseDouble(part[2 + i]);
        }
        shots.add(
            new Shot(
                Arrays.copyOf(numbers, beams),
                new Pose2(numbers[beams], numbers[beams + 1], numbers[beams + 2]),
                new Pose2(numbers[beams + 3], numbers[beams + 4], numbers[beams + 5])));
      }
    }
    return shots;
  }
}
