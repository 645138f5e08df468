package org.u2sa.scenarios.igvc;

import java.util.List;
import java.util.Random;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.sensor.NoiseStreams;

/**
 * Generates random courses according to the competition's rules until one passes the {@link
 * CourseChecker}: lanes of 10 to 20 ft with curves and switchbacks, dashed and worn paint, barrels,
 * sawhorses, potholes, flags, gaps too narrow to pass beside passable ones, a dead end, and
 * no-man's land with waypoints.
 */
final class CourseGenerator {
  private static final int REDRAWS = 10;
  private static final int TRIES = 40;
  private static final double CALMER = 8.0; // number of drafts until the sway is halved
  private static final double START_M = 1.2; // distance from the start of the lines to the vehicle
  private static final double CLEAR_M = 16.0; // no obstacles on the timed 44 ft
  private static final double PASSAGE_M = 1.65; // the rules require 5 ft
  private static final double DECOY_M = 1.1;
  private static final double FENCE_M = 0.6;
  private static final double FT = 0.3048;

  private final Random random;
  private CourseLayout layout;
  private Centreline line;
  private CourseBuilder builder;

  private CourseGenerator(Random random) {
    this.random = random;
  }

  /**
   * Generates the course of a seed. If too many drafts are illegal, redraws from a random stream
   * derived from the seed, which the course's name states.
   *
   * @throws IllegalStateException if no draft is legal
   */
  static Course course(long seed) {
    return course(seed, Ramps.SOME);
  }

  /**
   * Same, with ramps. They use a separate random stream, so that everything else remains the same.
   */
  static Course course(long seed, Ramps ramps) {
    String faults = "";
    for (int redraw = 0; redraw < REDRAWS; redraw++) {
      String stream = redraw == 0 ? "course" : "course redraw " + redraw;
      Random random = new NoiseStreams(seed).of(stream);
      String name = "course " + seed + (redraw == 0 ? "" : ", redraw " + redraw);
      for (int i = 0; i < TRIES; i++) {
        double sway = CALMER / (CALMER + i); // strong curves are too tight for wide lanes
        CourseGenerator generator = new CourseGenerator(random);
        Course course = generator.draft(name, sway);
        List<String> found = CourseChecker.faults(course);
        if (found.isEmpty()) {
          return generator.ramped(course, ramps, new NoiseStreams(seed).of("ramp"));
        }
        faults = found.toString();
      }
    }
    throw new IllegalStateException(
        "course " + seed + ": " + REDRAWS * TRIES + " drafts are illegal: " + faults);
  }

  private Course ramped(Course course, Ramps ramps, Random own) {
    return ramps.isDue(own)
        ? RampPlacer.place(course, layout, builder, own).orElse(course)
        : course;
  }

  private Course draft(String name, double sway) {
    layout = CourseLayout.random(random, sway);
    line = layout.line();
    int start = line.along(0, START_M);
    builder =
        new CourseBuilder(
            line.beside(start, 0.0), 2.0 * Math.PI * random.nextDouble(), random.nextBoolean());
    builder.start(line.beside(start, 0.0), line.beside(start + 10, 0.0));
    fence();
    lines();
    goals();
    int lanesEnd = layout.lanesEnd();
    obstacles(line.along(0, CLEAR_M), lanesEnd - 25);
    noMansLand();
    obstacles(layout.lanesBegin() + 25, line.count() - 60);
    return builder.course(name);
  }

  /** Fence slightly outside the field, so that a GPS error cannot shift it into a lane. */
  private void fence() {
    double west = -FENCE_M;
    double south = -FENCE_M;
    double east = CourseLayout.LENGTH_M + FENCE_M;
    double north = CourseLayout.WIDTH_M + FENCE_M;
    builder.line(
        Course.FENCE,
        List.of(
            Point.of(west, south, 0.0),
            Point.of(east, south, 0.0),
            Point.of(east, north, 0.0),
            Point.of(west, north, 0.0),
            Point.of(west, south, 0.0)));
  }

  private void lines() {
    int last = line.count() - 1;
    lane(0, layout.lanesEnd());
    lane(layout.lanesBegin(), last);
    for (int end : new int[] {0, last}) {
      double half = 0.5 * line.widthM(end);
      builder.line(Course.END, List.of(line.beside(end, -half), line.beside(end, half)));
    }
  }

  private void lane(int from, int to) {
    for (int side = -1; side <= 1; side += 2) {
      builder.line(Course.BOUNDARY, line.edge(from, to, side));
    }
    int at = from;
    boolean plain = from == 0; // the first metres are solid
    while (at < to) {
      int end = line.along(at, plain ? CLEAR_M : 8.0 + 12.0 * random.nextDouble());
      end = end > to - 30 ? to : end;
      double kind = random.nextDouble();
      if (!plain && kind < 0.3) {
        dashes(at, end, random.nextBoolean() ? 1 : -1);
      } else {
        for (int side = -1; side <= 1; side += 2) {
          boolean worn = !plain && random.nextDouble() < 0.25;
          builder.line(worn ? Scenery.WORN_LINE : Scenery.LINE, line.edge(at, end, side));
        }
      }
      plain = false;
      at = end;
    }
  }

  /** One side is solid; the other has dashes of 15 to 20 ft with gaps of 10 to 15 ft. */
  private void dashes(int from, int to, int side) {
    builder.line(Scenery.LINE, line.edge(from, to, -side));
    int at = from;
    while (at < to) {
      int dash = Math.min(to, line.alongEdge(at, side, (15.0 + 5.0 * random.nextDouble()) * FT));
      builder.line(Scenery.LINE, line.edge(at, dash, side));
      at = line.alongEdge(dash, side, (10.0 + 5.0 * random.nextDouble()) * FT);
    }
  }

  private void goals() {
    int begin = layout.lanesEnd();
    int end = layout.lanesBegin();
    builder.waypoint(line.beside(begin, 0.0));
    double aside = 1.6 * (random.nextDouble() - 0.5);
    builder.waypoint(line.beside((2 * begin + 3 * end) / 5, aside));
    builder.waypoint(line.beside(end, 0.0));
    builder.waypoint(line.beside(line.count() - 15, 0.0));
  }

  /** Successive groups of obstacles, each with a passage beside it. */
  private void obstacles(int from, int to) {
    int at = line.along(from, 2.0 * random.nextDouble());
    while (at < to) {
      int used = at;
      double width = line.widthM(at);
      switch (random.nextInt(7)) {
        case 0, 1 -> used = barrelAside(at, width);
        case 2 -> decoy(at, width);
        case 3 -> sawhorse(at, width);
        case 4 -> pothole(at, width);
        case 5 -> used = flags(at, Math.min(to, line.along(at, 4.0)), width);
        default -> gate(at, width);
      }
      at = line.along(used, 4.5 + 4.0 * random.nextDouble());
    }
  }

  /** One barrel, or two in a row, with the passage on the other side. */
  private int barrelAside(int at, double width) {
    int side = random.nextBoolean() ? 1 : -1;
    double most = 0.5 * width - PASSAGE_M - CourseBuilder.BARREL_RADIUS_M; // towards the passage
    double beside = most - random.nextDouble() * 1.2;
    builder.barrel(line.beside(at, -side * beside));
    if (random.nextBoolean()) {
      int next = line.along(at, 0.9);
      builder.barrel(line.beside(next, -side * (beside - 0.3)));
      return next;
    }
    return at;
  }

  /** Two barrels with a gap too narrow to pass; the passage is between one of them and the line. */
  private void decoy(int at, double width) {
    int side = random.nextBoolean() ? 1 : -1;
    double diameter = 2.0 * CourseBuilder.BARREL_RADIUS_M;
    double first = 0.5 * width - PASSAGE_M - CourseBuilder.BARREL_RADIUS_M;
    builder.barrel(line.beside(at, side * first));
    double second = first - diameter - DECOY_M;
    if (second > -0.5 * width) {
      builder.barrel(line.beside(at, side * second));
    }
  }

  /** A sawhorse across the lane, starting at one line. */
  private void sawhorse(int at, double width) {
    int side = random.nextBoolean() ? 1 : -1;
    double room = width - PASSAGE_M - 0.15;
    double length = Math.min(room, 1.2 + 0.6 * random.nextDouble());
    double middle = 0.5 * width - 0.1 - 0.5 * length;
    double turned = 0.3 * (random.nextDouble() - 0.5);
    builder.sawhorse(
        line.beside(at, side * middle), line.headingRad(at) + 0.5 * Math.PI + turned, length);
  }

  private void pothole(int at, double width) {
    int side = random.nextBoolean() ? 1 : -1;
    double most = 0.5 * width - PASSAGE_M - CourseBuilder.POTHOLE_RADIUS_M;
    builder.pothole(line.beside(at, side * (most - 0.8 * random.nextDouble())));
  }

  /** Alternating flags: red to the right of the path, blue to its left. */
  private int flags(int from, int to, double width) {
    int at = from;
    boolean red = random.nextBoolean();
    double passage = PASSAGE_M + 0.3;
    while (at < to) {
      double beside = Math.max(0.2, 0.5 * width - Math.max(0.3, 0.5 * (width - passage)));
      builder.flag(line.beside(at, (red ? -1 : 1) * beside), red);
      red = !red;
      at = line.along(at, 2.0);
    }
    return at;
  }

  /** Barrels on both sides, with the passage in the middle. */
  private void gate(int at, double width) {
    double passage = PASSAGE_M + 0.5 * random.nextDouble();
    double shift = 0.4 * (width - 2.6) * (random.nextDouble() - 0.5);
    double out = 0.5 * passage + CourseBuilder.BARREL_RADIUS_M;
    for (int side = -1; side <= 1; side += 2) {
      double beside = side * out + shift;
      if (Math.abs(beside) < 0.5 * width + 0.2) {
        builder.barrel(line.beside(at, beside));
      }
    }
  }

  /** Scattered barrels and sawhorses, and a dead end on the direct path. */
  private void noMansLand() {
    int begin = layout.lanesEnd();
    int end = layout.lanesBegin();
    int trap = begin + (int) ((0.32 + 0.1 * random.nextDouble()) * (end - begin));
    deadEnd(trap);
    int at = line.along(begin, 3.5 + 2.0 * random.nextDouble());
    while (at < end - 35) {
      boolean inTrap = Math.abs(at - trap) < 40;
      boolean onGoal = Math.abs(at - (2 * begin + 3 * end) / 5) < 22;
      if (!inTrap && !onGoal) {
        double beside = 3.0 * (random.nextDouble() - 0.5);
        if (random.nextDouble() < 0.7) {
          builder.barrel(line.beside(at, beside));
        } else {
          builder.sawhorse(line.beside(at, beside), Math.PI * random.nextDouble(), 1.5);
        }
      }
      at = line.along(at, 2.6 + 1.5 * random.nextDouble());
    }
  }

  /** Barrels in a U open towards the vehicle, with gaps narrower than any vehicle. */
  private void deadEnd(int at) {
    double shift = 0.8 * (random.nextDouble() - 0.5);
    for (int k = -1; k <= 1; k++) {
      builder.barrel(line.beside(at, shift + 0.85 * k));
    }
    for (int side = -1; side <= 1; side += 2) {
      builder.barrel(line.beside(line.along(at - 16, 0.7), shift + side * 1.25));
      builder.barrel(line.beside(line.along(at - 24, 0.7), shift + side * 1.4));
    }
  }
}
