package org.u2sa.report.picture;

import java.awt.Color;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jfree.chart.annotations.XYShapeAnnotation;
import org.jfree.chart.plot.XYPlot;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Rectangle;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.report.score.ObstacleResult;
import org.u2sa.report.score.RunPlan;
import org.u2sa.report.score.Surroundings;
import org.u2sa.report.score.TrackSample;

/**
 * Map layer of areas and obstacles, below everything else: static ones filled; moving ones at the
 * moment of closest approach, with their path around it, the time, and the vehicle's position then.
 */
final class ObstacleLayer {
  private static final Color STANDS = new Color(0x8a, 0x5a, 0x2b, 0x66);
  private static final Color EDGE = new Color(0x6b441f);
  private static final Color MOVES = new Color(0xcc, 0x79, 0xa7, 0x40);
  static final Color WAY = new Color(0xb0578a);
  private static final int SIDES = 48;
  private static final int WAY_STEPS = 24;
  private static final double WAY_S = 60.0; // before and after the closest approach
  private static final double MIN_RADIUS_M = 0.05; // of point objects
  private static final int MAX_NAMES = 20;
  private static final int AREA_ALPHA = 0x18;

  /** Chart coordinates of a global position. */
  @FunctionalInterface
  interface Chart {
    Point2D at(double longitudeDeg, double latitudeDeg);
  }

  private final RunPlan plan;
  private final List<ObstacleResult> results;
  private final List<TrackSample> track;
  private final Chart chart;

  /** Takes one result per object of the plan; objects without a result are omitted. */
  ObstacleLayer(RunPlan plan, List<ObstacleResult> results, List<TrackSample> track, Chart chart) {
    this.plan = plan;
    this.results = results;
    this.track = track;
    this.chart = chart;
  }

  void addTo(XYPlot plot) {
    for (Surroundings.Area area : plan.surroundings().areas()) {
      Color edge = areaColour(area);
      plot.addAnnotation(
          line(outline(area.outline()), true, edge, ChartStyle.withAlpha(edge, AREA_ALPHA)));
    }
    for (int i = 0; i < results.size(); i++) {
      ObjectDescription object = plan.surroundings().objects().get(i);
      ObstacleResult result = results.get(i);
      ObjectDescription then = Surroundings.after(object, result.timeS());
      if (result.moves()) {
        plot.addAnnotation(line(way(object, result.timeS()), false, WAY, null));
        plot.addAnnotation(line(separation(then, result.timeS()), true, WAY, null));
      }
      plot.addAnnotation(
          line(outline(then), true, result.moves() ? WAY : EDGE, result.moves() ? MOVES : STANDS));
    }
  }

  private static Color areaColour(Surroundings.Area area) {
    return area.isForbidden() ? ChartStyle.MISSED : ChartStyle.HOME;
  }

  /** Longitudes and latitudes of the outlines of areas and of objects that do not move [deg]. */
  List<List<Point2D>> outlines() {
    ObstacleLayer onEarth = new ObstacleLayer(plan, results, track, Point2D.Double::new);
    List<List<Point2D>> all = new ArrayList<>();
    plan.surroundings().areas().forEach(area -> all.add(onEarth.outline(area.outline())));
    for (int i = 0; i < results.size(); i++) {
      if (!results.get(i).moves()) {
        all.add(onEarth.outline(plan.surroundings().objects().get(i)));
      }
    }
    return all;
  }

  /** Paths of moving objects, and lines to the vehicle at the closest approaches. */
  List<List<Point2D>> ways() {
    List<List<Point2D>> all = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      if (results.get(i).moves()) {
        ObjectDescription object = plan.surroundings().objects().get(i);
        double timeS = results.get(i).timeS();
        all.add(way(object, timeS));
        all.add(separation(Surroundings.after(object, timeS), timeS));
      }
    }
    return all;
  }

  /** Positions of moving objects and of the vehicle at their closest approaches. */
  List<Point2D> moments() {
    List<Point2D> all = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      if (results.get(i).moves()) {
        ObjectDescription object = plan.surroundings().objects().get(i);
        double timeS = results.get(i).timeS();
        all.addAll(separation(Surroundings.after(object, timeS), timeS));
      }
    }
    return all;
  }

  /** From an object to the vehicle at a time of the run [s]. */
  private List<Point2D> separation(ObjectDescription then, double timeS) {
    List<Point2D> line = new ArrayList<>();
    line.add(place(then, middle(then)));
    track.stream()
        .min(Comparator.comparingDouble(sample -> Math.abs(sample.timeS() - timeS)))
        .map(sample -> chart.at(sample.longitudeDeg(), sample.latitudeDeg()))
        .ifPresent(line::add);
    return line;
  }

  /**
   * A name beside an object.
   *
   * @param outline of the object
   */
  record Name(String text, Point2D at, Color colour, List<Point2D> outline) {}

  /**
   * Names of all areas, and of all objects unless there are too many to be legible; with the time
   * for moving ones.
   */
  List<Name> names() {
    List<Name> names = new ArrayList<>();
    for (Surroundings.Area area : plan.surroundings().areas()) {
      Polygon outline = area.outline();
      names.add(
          new Name(
              outline.uid(), place(outline, middle(outline)), areaColour(area), outline(outline)));
    }
    for (int i = 0; i < results.size() && results.size() <= MAX_NAMES; i++) {
      ObstacleResult result = results.get(i);
      ObjectDescription then =
          Surroundings.after(plan.surroundings().objects().get(i), result.timeS());
      String time = result.moves() ? " " + ChartStyle.clock(result.timeS()) : "";
      names.add(
          new Name(
              named(then) + time,
              place(then, middle(then)),
              result.moves() ? WAY : EDGE,
              outline(then)));
    }
    return names;
  }

  /** Name of an object; of an unnamed one, which a world file numbers, with its type. */
  private static String named(ObjectDescription object) {
    String type = object.objectType();
    String shape = object.getClass().getSimpleName();
    return !type.isEmpty() && object.uid().matches(shape + " \\d+")
        ? type + " (" + object.uid() + ")"
        : object.uid();
  }

  /** Centre of an object; for a polygon the mean of its corners, since its centre may be absent. */
  static Point middle(ObjectDescription object) {
    if (!(object instanceof Polygon area) || area.points().isEmpty()) {
      return object.center();
    }
    // in metres, because the mean of longitudes on both sides of the antimeridian is far away
    Metric metric = Metric.around(object.referenceFrame(), area.points().get(0));
    Point sum = area.points().stream().map(metric::metres).reduce(Point.ORIGIN, Point::plus);
    double share = 1.0 / area.points().size();
    return metric.point(Point.of(share * sum.x(), share * sum.y(), share * sum.z()));
  }

  private static XYShapeAnnotation line(
      List<Point2D> points, boolean closed, Color edge, Color filling) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < points.size(); i++) {
      Point2D at = points.get(i);
      if (i == 0) {
        path.moveTo(at.getX(), at.getY());
      } else {
        path.lineTo(at.getX(), at.getY());
      }
    }
    if (closed) {
      path.closePath();
    }
    return new XYShapeAnnotation(path, ChartStyle.stroke(1.3, closed ? 0.0 : 3.0), edge, filling);
  }

  private List<Point2D> way(ObjectDescription object, double timeS) {
    List<Point2D> way = new ArrayList<>();
    double from = Math.max(0.0, timeS - WAY_S);
    for (int i = 0; i <= WAY_STEPS; i++) {
      double seconds = from + (timeS + WAY_S - from) * i / WAY_STEPS;
      way.add(place(object, Surroundings.centreAfter(object, seconds)));
    }
    return way;
  }

  /** Outline seen from above. */
  private List<Point2D> outline(ObjectDescription object) {
    List<Point2D> points = new ArrayList<>();
    if (object instanceof Polygon area) {
      area.points().forEach(point -> points.add(place(object, point)));
    } else if (object instanceof Box box) {
      corners(points, object, box.length(), box.width(), box.psi());
    } else if (object instanceof Dock dock) {
      corners(points, object, dock.length(), dock.width(), dock.psi());
    } else if (object instanceof Rectangle flat) {
      corners(points, object, flat.length(), flat.width(), flat.psi());
    } else {
      double radius = radiusM(object);
      for (int i = 0; i < SIDES; i++) {
        double angle = 2.0 * Math.PI * i / SIDES;
        points.add(beside(object, radius * Math.cos(angle), radius * Math.sin(angle)));
      }
    }
    return points;
  }

  private void corners(
      List<Point2D> points, ObjectDescription object, double length, double width, double psi) {
    for (int corner = 0; corner < 4; corner++) {
      double along = corner < 2 ? 0.5 * length : -0.5 * length;
      double across = corner == 0 || corner == 3 ? 0.5 * width : -0.5 * width;
      double x = along * Math.cos(psi) - across * Math.sin(psi);
      double y = along * Math.sin(psi) + across * Math.cos(psi);
      // In global frames psi is clockwise from north, and the first axis of metres is east.
      points.add(object.referenceFrame().isEarth() ? beside(object, y, x) : beside(object, x, y));
    }
  }

  private static double radiusM(ObjectDescription object) {
    double radius = 0.0;
    if (object instanceof Cylinder cylinder) {
      radius = cylinder.radius();
    } else if (object instanceof Sphere sphere) {
      radius = sphere.radius();
    } else if (object instanceof Circle circle) {
      radius = circle.radius();
    } else if (object instanceof Hoop hoop) {
      radius = hoop.radius();
    }
    return Math.max(MIN_RADIUS_M, radius);
  }

  /** Point offset from the centre [m] along the frame's axes; east and north in global frames. */
  private Point2D beside(ObjectDescription object, double x, double y) {
    Point metres = Point.of(x, y, 0.0);
    return place(object, Metric.around(object.referenceFrame(), object.center()).point(metres));
  }

  private Point2D place(ObjectDescription object, Point point) {
    // without a home there are no objects in local frames
    Geodetic home = plan.home().map(RunPlan.Start::place).orElse(new Geodetic(0.0, 0.0, 0.0));
    Geodetic place = Surroundings.onEarth(object, point, home);
    return chart.at(place.longitudeDeg(), place.latitudeDeg());
  }
}
