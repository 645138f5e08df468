package org.u2sa.world.object;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Sighting;

/**
 * Enters the sightings of a published MRCLAM data set (UTIAS; Leung et al., "The UTIAS multi-robot
 * cooperative localization and mapping dataset", IJRR 30, 2011) into the World Modeler's map of
 * objects, from the robots' true poses, and compares it with the surveyed landmarks and with the
 * other robots' true ways: {@code LandmarkMap data/MRCLAM_Dataset6 …}. Prints a table.
 */
final class LandmarkMap {
  private static final int ROBOTS = 5;
  private static final double RANGE_SIGMA = 0.15;
  private static final double BEARING_SIGMA = 0.05;

  private record Seen(double time, int subject, double range, double bearing) {}

  public static void main(String[] folders) throws IOException {
    System.out.println(
        "| data | seen by | UIDs | landmarks found of seen | more objects | mean error | largest "
            + "| error/sigma, RMS | robots: in the map within 1 m | median error |");
    System.out.println("|---|---|---|---|---|---|---|---|---|---|");
    for (String folder : folders) {
      for (int robot = 1; robot <= ROBOTS; robot++) {
        for (boolean trusted : new boolean[] {true, false}) {
          run(Path.of(folder), robot, trusted);
        }
      }
    }
  }

  private static List<double[]> table(Path file) throws IOException {
    List<double[]> rows = new ArrayList<>();
    for (String line : Files.readAllLines(file, StandardCharsets.US_ASCII)) {
      if (!line.startsWith("#") && !line.isBlank()) {
        String[] parts = line.trim().split("\\s+");
        double[] row = new double[parts.length];
        for (int i = 0; i < row.length; i++) {
          row[i] = Double.parseDouble(parts[i]);
        }
        rows.add(row);
      }
    }
    return rows;
  }

  private static TreeMap<Double, double[]> poses(Path folder, int robot) throws IOException {
    TreeMap<Double, double[]> poses = new TreeMap<>();
    for (double[] row : table(folder.resolve("Robot" + robot + "_Groundtruth.dat"))) {
      poses.put(row[0], row);
    }
    return poses;
  }

  private static void run(Path folder, int robot, boolean trusted) throws IOException {
    Map<Integer, Integer> subjects = new LinkedHashMap<>(); // by barcode
    table(folder.resolve("Barcodes.dat")).forEach(row -> subjects.put((int) row[1], (int) row[0]));
    Map<Integer, Point> landmarks = new LinkedHashMap<>();
    table(folder.resolve("Landmark_Groundtruth.dat"))
        .forEach(row -> landmarks.put((int) row[0], Point.of(row[1], row[2], 0.0)));
    List<TreeMap<Double, double[]>> robots = new ArrayList<>();
    for (int each = 1; each <= ROBOTS; each++) {
      robots.add(poses(folder, each));
    }
    TreeMap<Double, List<Seen>> sightings = new TreeMap<>();
    for (double[] row : table(folder.resolve("Robot" + robot + "_Measurement.dat"))) {
      Integer subject = subjects.get((int) row[1]);
      if (subject != null) { // a misread barcode is nobody's
        sightings
            .computeIfAbsent(row[0], time -> new ArrayList<>())
            .add(new Seen(row[0], subject, row[2], row[3]));
      }
    }
    ObjectMapModeller map =
        new ObjectMapModeller(
            XmlConfiguration.inMemory(
                "benchmark",
                Map.of(
                    "TRUST UIDS", trusted,
                    "CONFIRM HITS", 2,
                    "CONFIRM WINDOW", 31,
                    "USUAL SPEED", 0.1,
                    "MOVERS", "robot",
                    "MANOEUVRES", 0.1,
                    "MERGE WITHIN", trusted ? 0.0 : 0.1)));
    MapFrame frame = MapFrame.of(state(0.0, new double[] {0.0, 0.0, 0.0, 0.0}));
    map.enter(frame, new Sighting(0L, frame, Optional.empty()));
    Map<Integer, Integer> counts = new TreeMap<>();
    List<Double> moving = new ArrayList<>();
    int robotSightings = 0;
    long micros = 0L;
    for (Map.Entry<Double, List<Seen>> entry : sightings.entrySet()) {
      double[] pose = at(robots.get(robot - 1), entry.getKey());
      if (pose == null) {
        continue;
      }
      micros = micros(entry.getKey());
      Sighting sighting =
          new Sighting(micros, frame, Optional.of(state(entry.getKey(), pose)));
      List<ObjectDescription> objects = new ArrayList<>();
      for (Seen seen : entry.getValue()) {
        counts.merge(seen.subject(), 1, Integer::sum);
        objects.add(object(seen, trusted));
      }
      map.objects(objects, sighting);
      for (Seen seen : entry.getValue()) {
        double[] truth = seen.subject() <= ROBOTS ? at(robots.get(seen.subject() - 1), seen.time()) : null;
        if (truth != null) {
          robotSightings++;
          nearest(map.objects(sighting), Point.of(truth[1], truth[2], 0.0), "robot")
              .map(object -> object.center().distanceTo(Point.of(truth[1], truth[2], 0.0)))
              .filter(error -> error < 1.0)
              .ifPresent(moving::add);
        }
      }
    }
    report(folder, robot, trusted, landmarks, counts, map.objects(new Sighting(micros, frame, Optional.empty())), moving, robotSightings);
  }

  private static void report(
      Path folder,
      int robot,
      boolean trusted,
      Map<Integer, Point> landmarks,
      Map<Integer, Integer> counts,
      List<ObjectDescription> objects,
      List<Double> moving,
      int robotSightings) {
    int seen = 0;
    int found = 0;
    double sum = 0.0;
    double largest = 0.0;
    double normalised = 0.0;
    List<ObjectDescription> left = new ArrayList<>(objects);
    left.removeIf(object -> !object.objectType().equals("landmark"));
    for (Map.Entry<Integer, Point> landmark : landmarks.entrySet()) {
      if (counts.getOrDefault(landmark.getKey(), 0) < 3) {
        continue;
      }
      seen++;
      Optional<ObjectDescription> object =
          trusted
              ? left.stream().filter(each -> each.uid().equals("Subject " + landmark.getKey())).findFirst()
              : nearest(left, landmark.getValue(), "landmark")
                  .filter(each -> each.center().distanceTo(landmark.getValue()) < 0.5);
      if (object.isPresent()) {
        left.remove(object.get());
        found++;
        Point off = object.get().center().minus(landmark.getValue());
        Point sigma = object.get().motion().sigma().orElseThrow();
        double error = Math.hypot(off.x(), off.y());
        sum += error;
        largest = Math.max(largest, error);
        normalised += (Math.pow(off.x() / sigma.x(), 2) + Math.pow(off.y() / sigma.y(), 2)) / 2.0;
      }
    }
    moving.sort(null);
    System.out.printf(
        "| %s | robot %d | %s | %d of %d | %d | %.3f m | %.3f m | %.1f | %d of %d | %s |%n",
        folder.getFileName(),
        robot,
        trusted ? "barcodes" : "none",
        found,
        seen,
        left.size(),
        sum / found,
        largest,
        Math.sqrt(normalised / found),
        moving.size(),
        robotSightings,
        moving.isEmpty() ? "" : String.format("%.2f m", moving.get(moving.size() / 2)));
  }

  private static Optional<ObjectDescription> nearest(
      List<ObjectDescription> objects, Point place, String type) {
    ObjectDescription nearest = null;
    for (ObjectDescription each : objects) {
      boolean nearer =
          nearest == null
              || each.center().distanceTo(place) < nearest.center().distanceTo(place);
      nearest = each.objectType().equals(type) && nearer ? each : nearest;
    }
    return Optional.ofNullable(nearest);
  }

  private static long micros(double time) {
    return Math.round(1e6 * (time - 1.248e9));
  }

  private static StateInformation state(double time, double[] pose) {
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(pose[1])
            .y(pose[2])
            .psi(pose[3]);
    state.timestamp(micros(time));
    return state;
  }

  /** The true pose nearest in time, within 50 ms; else null. */
  private static double[] at(TreeMap<Double, double[]> poses, double time) {
    Map.Entry<Double, double[]> before = poses.floorEntry(time);
    Map.Entry<Double, double[]> after = poses.ceilingEntry(time);
    Map.Entry<Double, double[]> best =
        before == null || after != null && after.getKey() - time < time - before.getKey()
            ? after
            : before;
    return best == null || Math.abs(best.getKey() - time) > 0.05 ? null : best.getValue();
  }

  private static ObjectDescription object(Seen seen, boolean trusted) {
    Point at = Point.polar(seen.bearing(), 0.0, seen.range());
    boolean isRobot = seen.subject() <= ROBOTS;
    ObjectDescription object =
        new ObjectDescription()
            .uid(trusted ? "Subject " + seen.subject() : isRobot ? "robot" : "landmark")
            .objectType(isRobot ? "robot" : "landmark")
            .sensorName("camera")
            .referenceFrame(ReferenceFrame.BODY_FLU)
            .x(at.x())
            .y(at.y());
    double cos = Math.cos(seen.bearing());
    double sin = Math.sin(seen.bearing());
    double across = BEARING_SIGMA * seen.range();
    object
        .motion()
        .sigma(
            Point.of(
                Math.hypot(RANGE_SIGMA * cos, across * sin),
                Math.hypot(RANGE_SIGMA * sin, across * cos),
                0.1));
    return object;
  }
}
