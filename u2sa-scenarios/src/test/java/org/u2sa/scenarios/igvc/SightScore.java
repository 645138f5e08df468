package org.u2sa.scenarios.igvc;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.vision.camera.CourseSight.Seen;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.lens.LensCalibration.Spot;
import org.u2sa.vision.line.PaintFinder.PaintedLine;
import org.u2sa.vision.object.SeenObject;

/** Compares what was seen in rendered pictures with what is there. */
final class SightScore {
  private static final double SAMPLE_M = 0.05;
  private static final double NEAR_LINE_M = 0.10; // a line within this and the next is the line
  private static final double NEAR_LINE_SHARE = 0.04; // of the distance
  private static final double MARGIN_PX = 8.0;

  private final double nearM;
  private final double farM;
  private final double sideM;
  private final double objectsM;
  private long linesThere;
  private long linesSeen;
  private long linesTold;
  private long linesTrue;
  private final List<Double> errors = new ArrayList<>();
  private final List<Double> normalised = new ArrayList<>();
  private final Map<String, long[]> objects = new TreeMap<>(); // there, seen, told, true
  private final Map<String, List<Double>> ranges = new TreeMap<>(); // relative errors of range

  SightScore(double nearM, double farM, double sideM, double objectsM) {
    this.nearM = nearM;
    this.farM = farM;
    this.sideM = sideM;
    this.objectsM = objectsM;
  }

  /** Counts one picture. */
  void add(List<ObjectDescription> world, VehicleTruth truth, Seen seen) {
    GroundView view = seen.view();
    List<Point> there = new ArrayList<>();
    for (ObjectDescription object : world) {
      boolean isLine =
          object.objectType().equals(Scenery.LINE) || object.objectType().equals(Scenery.WORN_LINE);
      if (isLine && object instanceof PolyLine line) {
        samples(line.points()).forEach(point -> there.add(level(point, truth, view)));
      }
    }
    List<Point> told = new ArrayList<>();
    for (PaintedLine line : seen.lines()) {
      told.addAll(samples(line.points()));
    }
    for (Point point : there) {
      if (isVisible(point, world, truth, view)) {
        linesThere++;
        linesSeen += nearest(point, told) <= tolerance(point) ? 1 : 0;
      }
    }
    for (Point point : told) {
      double off = nearest(point, there);
      linesTold++;
      if (off <= tolerance(point)) {
        linesTrue++;
        errors.add(off);
      }
    }
    objects(world, truth, seen);
  }

  private void objects(List<ObjectDescription> world, VehicleTruth truth, Seen seen) {
    GroundView view = seen.view();
    List<String> types = List.of("barrel", "sawhorse", "red flag", "blue flag", "pothole");
    for (String type : types) {
      List<Point> told = new ArrayList<>();
      List<Double> sigmas = new ArrayList<>();
      if (type.equals("pothole")) {
        seen.discs().forEach(disc -> told.add(disc.centre()));
      }
      for (SeenObject object : seen.objects()) {
        if (object.kind().typeName().equals(type)) {
          told.add(object.foot());
          sigmas.add(object.alongM());
        }
      }
      long[] counts = objects.computeIfAbsent(type, name -> new long[4]);
      List<Point> there = new ArrayList<>();
      for (ObjectDescription object : world) {
        if (object.objectType().equals(type)) {
          Point place = level(object.center(), truth, view);
          there.add(place);
          double far = type.equals("pothole") ? farM - 0.4 : objectsM;
          boolean isIn =
              type.equals("pothole")
                  ? isVisible(place, world, truth, view) && place.x() > nearM + 0.4
                  : place.distance() < far && isWhole(object, place, world, truth, view);
          if (isIn && place.distance() < far) {
            counts[0]++;
            counts[1] += nearest(place, told) <= objectTolerance(place) ? 1 : 0;
          }
        }
      }
      for (int i = 0; i < told.size(); i++) {
        Point point = told.get(i);
        if (point.distance() > objectsM) {
          continue;
        }
        counts[2]++;
        Point best = null;
        for (Point place : there) {
          best = best == null || place.distanceTo(point) < best.distanceTo(point) ? place : best;
        }
        if (best != null && flat(best, point) <= objectTolerance(best)) {
          counts[3]++;
          double error =
              Math.hypot(point.x() - view.camera().x(), point.y() - view.camera().y())
                  - Math.hypot(best.x() - view.camera().x(), best.y() - view.camera().y());
          ranges
              .computeIfAbsent(type, name -> new ArrayList<>())
              .add(error / Math.max(0.1, best.distance()));
          if (!sigmas.isEmpty()) {
            normalised.add(error / sigmas.get(i));
          }
        }
      }
    }
  }

  private static double flat(Point a, Point b) {
    return Math.hypot(a.x() - b.x(), a.y() - b.y());
  }

  private static double objectTolerance(Point place) {
    return Math.max(0.5, 0.20 * place.distance());
  }

  private static double tolerance(Point point) {
    return NEAR_LINE_M + NEAR_LINE_SHARE * Math.hypot(point.x(), point.y());
  }

  private static double nearest(Point point, List<Point> others) {
    double least = Double.POSITIVE_INFINITY;
    for (Point other : others) {
      double x = other.x() - point.x();
      double y = other.y() - point.y();
      least = Math.min(least, x * x + y * y);
    }
    return Math.sqrt(least);
  }

  private static List<Point> samples(List<Point> line) {
    List<Point> samples = new ArrayList<>();
    for (int i = 1; i < line.size(); i++) {
      Point a = line.get(i - 1);
      Point b = line.get(i);
      int steps = Math.max(1, (int) Math.round(a.distanceTo(b) / SAMPLE_M));
      for (int k = 0; k < steps; k++) {
        double share = (double) k / steps;
        samples.add(
            Point.of(
                a.x() + share * (b.x() - a.x()),
                a.y() + share * (b.y() - a.y()),
                a.z() + share * (b.z() - a.z())));
      }
    }
    return samples;
  }

  /** From east and north to LEVEL. */
  static Point level(Point enu, VehicleTruth truth, GroundView view) {
    double east = enu.x() - truth.position().x();
    double north = enu.y() - truth.position().y();
    double sin = Math.sin(truth.headingRad());
    double cos = Math.cos(truth.headingRad());
    return view.onGround(north * cos + east * sin, east * cos - north * sin);
  }

  private boolean isVisible(
      Point level, List<ObjectDescription> world, VehicleTruth truth, GroundView view) {
    if (level.x() < nearM + 0.15
        || level.x() > farM - 0.15
        || Math.abs(level.y()) > sideM - 0.25
        || !isInPicture(level, view)) {
      return false;
    }
    return !isBehind(level, world, truth, view, null);
  }

  private static boolean isInPicture(Point level, GroundView view) {
    Optional<Spot> pixel = view.pixel(level);
    return pixel.isPresent()
        && pixel.get().x() > MARGIN_PX
        && pixel.get().y() > MARGIN_PX
        && pixel.get().x() < view.lens().width() - MARGIN_PX
        && pixel.get().y() < view.lens().height() - MARGIN_PX;
  }

  /** Whether something stands between the camera and a place on the ground. */
  private static boolean isBehind(
      Point level,
      List<ObjectDescription> world,
      VehicleTruth truth,
      GroundView view,
      ObjectDescription itself) {
    Point camera = view.camera();
    double x = level.x() - camera.x();
    double y = level.y() - camera.y();
    double range = Math.hypot(x, y);
    for (ObjectDescription object : world) {
      boolean stands = object instanceof Cylinder || object.objectType().equals(Scenery.SAWHORSE);
      boolean isWide =
          object.objectType().equals(Scenery.BARREL)
              || object.objectType().equals(Scenery.SAWHORSE);
      if (!stands || !isWide || object == itself) {
        continue;
      }
      double radius = object instanceof Cylinder cylinder ? cylinder.radius() + 0.1 : 0.7;
      Point place = level(object.center(), truth, view);
      double along = ((place.x() - camera.x()) * x + (place.y() - camera.y()) * y) / range;
      double aside = Math.abs((place.x() - camera.x()) * y - (place.y() - camera.y()) * x) / range;
      if (along > 0.0 && along - radius < range && aside < radius) {
        return true; // whatever is seen above it is not counted
      }
    }
    return false;
  }

  private static boolean isWhole(
      ObjectDescription object,
      Point place,
      List<ObjectDescription> world,
      VehicleTruth truth,
      GroundView view) {
    boolean isFlag = object.objectType().endsWith("flag");
    double side = isFlag ? 0.4 : object.objectType().equals(Scenery.SAWHORSE) ? 0.8 : 0.4;
    Point left = Point.of(place.x(), place.y() - side, place.z());
    Point right = Point.of(place.x(), place.y() + side, place.z());
    Point top = Point.of(place.x(), place.y(), place.z() - (isFlag ? 0.8 : 0.3));
    return isInPicture(left, view)
        && isInPicture(right, view)
        && isInPicture(top, view)
        && isInPicture(Point.of(place.x() - side, place.y(), place.z()), view)
        && !isBehind(place, world, truth, view, object);
  }

  double linePrecision() {
    return linesTold == 0 ? 1.0 : (double) linesTrue / linesTold;
  }

  double lineRecall() {
    return linesThere == 0 ? 1.0 : (double) linesSeen / linesThere;
  }

  /** Distance of a line's points from the paint, the given share of them is nearer [m]. */
  double lineError(double share) {
    return quantile(errors, share);
  }

  /** Share of objects of a type, whole in the picture, that are found. */
  double recall(String type) {
    long[] counts = objects.getOrDefault(type, new long[4]);
    return counts[0] == 0 ? 1.0 : (double) counts[1] / counts[0];
  }

  /** Share of what is reported that is one. */
  double precision(String type) {
    long[] counts = objects.getOrDefault(type, new long[4]);
    return counts[2] == 0 ? 1.0 : (double) counts[3] / counts[2];
  }

  private static double quantile(List<Double> of, double share) {
    double[] sorted = of.stream().mapToDouble(Math::abs).sorted().toArray();
    return sorted.length == 0 ? 0.0 : sorted[(int) (share * (sorted.length - 1))];
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "lines: precision %.3f recall %.3f (%d m there, %d m told), off median %.3f, 95%% %.3f m%n",
            linePrecision(),
            lineRecall(),
            Math.round(linesThere * SAMPLE_M),
            Math.round(linesTold * SAMPLE_M),
            lineError(0.5),
            lineError(0.95)));
    objects.forEach(
        (type, counts) ->
            text.append(
                String.format(
                    Locale.ROOT,
                    "%s: precision %.3f of %d, recall %.3f of %d; range off median %.3f, 95%% %.3f%n",
                    type,
                    precision(type),
                    counts[2],
                    recall(type),
                    counts[0],
                    quantile(ranges.getOrDefault(type, List.of()), 0.5),
                    quantile(ranges.getOrDefault(type, List.of()), 0.95))));
    double[] sorted = normalised.stream().mapToDouble(Math::abs).sorted().toArray();
    long within = Arrays.stream(sorted).filter(each -> each <= 2.0).count();
    text.append(
        String.format(
            Locale.ROOT,
            "objects' range within 2 sigma: %.3f of %d%n",
            sorted.length == 0 ? 1.0 : (double) within / sorted.length,
            sorted.length));
    return text.toString();
  }
}
