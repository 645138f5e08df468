package org.u2sa.scenarios.suas;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.world.Terrain;

/**
 * Generates fields according to the rules: 10 to 14 waypoints, a concave search area of 7 to 11 ha
 * with targets, cylinders of 10 to 45 m radius, and other aircraft, within a boundary of about 1.4
 * km around a runway, from which the aircraft takes off into the wind.
 */
final class SuasFieldGenerator {
  private static final double BOUNDARY_M = 1450.0;
  private static final double FLOOR_M = 25.0;
  private static final double CEILING_M = 200.0;
  private static final double RESOLUTION_M = 0.05;
  private static final double INSIDE_M = 450.0; // distance of waypoints from the boundary
  private static final double STRIP_M = 140.0; // kept free beside the runway's axis
  private static final double STRIP_LENGTH_M = 900.0;
  private static final double MAX_TURN_RAD = Math.toRadians(115.0);
  private static final int TRIES = 4000;
  static final String[] SHAPES = {"circle", "square", "triangle", "star", "cross", "pentagon"};
  static final String[] COLOURS = {"white", "black", "red", "blue", "yellow", "orange", "purple"};
  private static final String LETTERS = BlockLetters.ALL;

  private final Random random;
  private final double runwayRad;
  private final List<Point> boundary = new ArrayList<>();
  private final List<Point> area = new ArrayList<>();
  private final List<Point> waypoints = new ArrayList<>();
  private final List<SuasField.Pillar> pillars = new ArrayList<>();

  private SuasFieldGenerator(long seed) {
    random = new Random(seed * 0x9E3779B97F4A7C15L);
    random.nextLong(); // neighbouring seeds have similar first numbers
    runwayRad = between(0.0, 2.0 * Math.PI);
  }

  static SuasField field(long seed, double windMps) {
    return new SuasFieldGenerator(seed).draw(seed, windMps);
  }

  private SuasField draw(long seed, double windMps) {
    int corners = 8;
    for (int i = 0; i < corners; i++) {
      double angle = (i + between(-0.2, 0.2)) * 2.0 * Math.PI / corners;
      double away = BOUNDARY_M * between(0.95, 1.15);
      boundary.add(Point.of(away * Math.cos(angle), away * Math.sin(angle), 0.0));
    }
    drawArea();
    drawWaypoints(10 + random.nextInt(5));
    drawPillars(6 + random.nextInt(5));
    double windFromRad = runwayRad + Math.toRadians(between(-50.0, 50.0));
    return new SuasField(
        runwayRad,
        List.copyOf(boundary),
        FLOOR_M,
        CEILING_M,
        List.copyOf(waypoints),
        List.copyOf(pillars),
        List.copyOf(area),
        RESOLUTION_M,
        targets(4 + random.nextInt(3)),
        traffic(2 + random.nextInt(2)),
        windMps,
        windFromRad,
        drop(),
        between(99_000.0, 103_000.0),
        seed,
        Terrain.flat());
  }

  private double between(double least, double most) {
    return least + (most - least) * random.nextDouble();
  }

  /** An L, a wedge or a rectangle with a notch, turned at random, beside the runway. */
  private void drawArea() {
    double length = between(330.0, 430.0);
    double width = between(240.0, 300.0);
    double notch = between(0.3, 0.6);
    double depth = between(0.3, 0.5);
    double[][] shape =
        random.nextBoolean()
            ? new double[][] {
              {0, 0},
              {length, 0},
              {length, width * depth},
              {length * notch, width * depth},
              {length * notch, width},
              {0, width}
            }
            : new double[][] {
              {0, 0},
              {length, 0},
              {length, width},
              {length * notch, width * (1 - depth)},
              {0, width}
            };
    double side = random.nextBoolean() ? 1.0 : -1.0;
    double along = between(-250.0, 250.0);
    double across = side * between(430.0, 480.0);
    double turn = between(0.0, 2.0 * Math.PI);
    double sin = Math.sin(runwayRad);
    double cos = Math.cos(runwayRad);
    for (double[] corner : shape) {
      double x = corner[0] - 0.5 * length;
      double y = corner[1] - 0.5 * width;
      area.add(
          Point.of(
              along * sin + across * cos + x * Math.cos(turn) - y * Math.sin(turn),
              along * cos - across * sin + x * Math.sin(turn) + y * Math.cos(turn),
              0.0));
    }
  }

  private boolean isFree(double east, double north, double radius, double fromArea) {
    double limit = radius + fromArea;
    return SuasField.isInside(boundary, east, north)
        && SuasField.edgeM(boundary, east, north) > INSIDE_M + radius
        && (area.isEmpty()
            || !SuasField.isInside(area, east, north)
                && SuasField.edgeM(area, east, north) > limit);
  }

  private boolean isNearRunway(double east, double north, double radius) {
    Point from = axis(-STRIP_LENGTH_M);
    Point to = axis(STRIP_LENGTH_M);
    return Point.of(east, north, 0.0).flatDistanceTo(from, to) < STRIP_M + radius;
  }

  private Point axis(double along) {
    return Point.of(along * Math.sin(runwayRad), along * Math.cos(runwayRad), 0.0);
  }

  private void drawWaypoints(int count) {
    Point before = axis(0.0);
    Point last = axis(400.0);
    for (int tries = 0; waypoints.size() < count && tries < TRIES; tries++) {
      double turn = between(-MAX_TURN_RAD, MAX_TURN_RAD);
      double course = Math.atan2(last.x() - before.x(), last.y() - before.y()) + turn;
      double leg = between(300.0, 520.0);
      double east = last.x() + leg * Math.sin(course);
      double north = last.y() + leg * Math.cos(course);
      if (isFree(east, north, 0.0, Double.NEGATIVE_INFINITY)) {
        Point next = Point.of(east, north, between(60.0, 130.0));
        waypoints.add(next);
        before = last;
        last = next;
      } else if (tries % 200 == 199 && !waypoints.isEmpty()) { // a dead end
        waypoints.remove(waypoints.size() - 1);
        last = waypoints.isEmpty() ? axis(400.0) : waypoints.get(waypoints.size() - 1);
        before = waypoints.size() < 2 ? axis(0.0) : waypoints.get(waypoints.size() - 2);
      }
    }
  }

  private void drawPillars(int count) {
    for (int tries = 0; pillars.size() < count && tries < TRIES; tries++) {
      double east = between(-BOUNDARY_M, BOUNDARY_M);
      double north = between(-BOUNDARY_M, BOUNDARY_M);
      double radius = between(10.0, 45.0);
      boolean free =
          isFree(east, north, radius - INSIDE_M, INSIDE_M + 150.0)
              && !isNearRunway(east, north, radius);
      for (Point waypoint : waypoints) {
        free &= Math.hypot(waypoint.x() - east, waypoint.y() - north) > radius + 90.0;
      }
      for (SuasField.Pillar other : pillars) {
        double apart = Math.hypot(other.eastM() - east, other.northM() - north);
        free &= apart > radius + other.radiusM() + 180.0;
      }
      if (free) {
        pillars.add(new SuasField.Pillar(east, north, radius, between(60.0, 180.0)));
      }
    }
  }

  /** A random position inside the boundary, with room to approach it from any side. */
  private Point drop() {
    Point drop = axis(0.0);
    for (int tries = 0; tries < TRIES && drop.distance() == 0.0; tries++) {
      double east = between(-BOUNDARY_M, BOUNDARY_M);
      double north = between(-BOUNDARY_M, BOUNDARY_M);
      boolean free =
          isFree(east, north, 0.0, Double.NEGATIVE_INFINITY) && !isNearRunway(east, north, 0.0);
      for (SuasField.Pillar pillar : pillars) {
        double apart = Math.hypot(pillar.eastM() - east, pillar.northM() - north);
        free &= apart > pillar.radiusM() + 200.0;
      }
      drop = free ? Point.of(east, north, 0.0) : drop;
    }
    return drop;
  }

  private List<SuasTarget> targets(int count) {
    List<SuasTarget> targets = new ArrayList<>();
    for (int tries = 0; targets.size() < count && tries < TRIES; tries++) {
      double east = between(-BOUNDARY_M, BOUNDARY_M);
      double north = between(-BOUNDARY_M, BOUNDARY_M);
      boolean apart =
          targets.stream()
              .allMatch(other -> Math.hypot(other.eastM() - east, other.northM() - north) > 40.0);
      if (apart
          && SuasField.isInside(area, east, north)
          && SuasField.edgeM(area, east, north) > 8.0) {
        int colour = random.nextInt(COLOURS.length);
        int other = (colour + 1 + random.nextInt(COLOURS.length - 1)) % COLOURS.length;
        targets.add(
            new SuasTarget(
                east,
                north,
                0.0,
                between(1.2, 1.6),
                between(0.0, 2.0 * Math.PI),
                SHAPES[random.nextInt(SHAPES.length)],
                COLOURS[colour],
                String.valueOf(LETTERS.charAt(random.nextInt(LETTERS.length()))),
                COLOURS[other]));
      }
    }
    return targets;
  }

  /** Back and forth through the field, clear of the runway's ends. */
  private List<SuasField.Traffic> traffic(int count) {
    List<SuasField.Traffic> traffic = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double direction = runwayRad + between(-0.6, 0.6);
      double aside = (random.nextBoolean() ? 1.0 : -1.0) * between(350.0, 700.0);
      double half = between(1200.0, 1800.0);
      double sin = Math.sin(direction);
      double cos = Math.cos(direction);
      double up = between(60.0, 130.0);
      double way = random.nextBoolean() ? half : -half;
      traffic.add(
          new SuasField.Traffic(
              "aircraft " + (i + 1),
              Point.of(-way * sin + aside * cos, -way * cos - aside * sin, up),
              Point.of(way * sin + aside * cos, way * cos - aside * sin, up),
              between(15.0, 25.0)));
    }
    return traffic;
  }
}
