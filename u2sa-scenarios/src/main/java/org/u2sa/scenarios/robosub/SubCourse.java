package org.u2sa.scenarios.robosub;

import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * A layout. Places are north, east and down of the start, which faces north at the surface [m].
 *
 * @param stages tasks in order; those of one stage may be done in any order (thesis, figure 21)
 * @param currentEastMps of the water
 * @param currentNorthMps of the water
 */
record SubCourse(List<List<CourseTask>> stages, double currentEastMps, double currentNorthMps) {
  /** Place of the layout's start. */
  static final Geodetic ORIGIN = new Geodetic(-117.25, 32.7, 0.0);

  private static final double SIDE_M = 1.5; // width of each side of the gate: 10 feet for both
  private static final double MAX_CURRENT_MPS = 0.05;

  /** The layout of a seed. */
  static SubCourse of(long seed) {
    Random random = new Random(seed * 0x9E3779B97F4A7C15L);
    Point gate =
        Point.of(between(random, 5.0, 8.0), between(random, -2.0, 2.0), between(random, 1.3, 2.0));
    double turn = between(random, -0.35, 0.35);
    Point across = Point.of(-Math.sin(turn), Math.cos(turn), 0.0).times(SIDE_M);
    Point first =
        Point.of(
            gate.x() + between(random, 5.0, 7.0),
            gate.y() + between(random, -1.5, 1.5),
            between(random, 1.3, 2.5));
    double aside = (random.nextBoolean() ? 1.0 : -1.0) * between(random, 1.2, 2.0);
    Point second =
        Point.of(
            first.x() + between(random, 3.0, 4.5), first.y() + aside, between(random, 1.3, 2.5));
    List<Colour> colours =
        random.nextBoolean()
            ? List.of(Colour.RED, Colour.GREEN)
            : List.of(Colour.GREEN, Colour.RED);
    Point ring =
        Point.of(
            second.x() + between(random, 5.0, 8.0), second.y() + between(random, -2.5, 2.5), 0.0);
    double to = between(random, -Math.PI, Math.PI);
    double speed = between(random, 0.0, MAX_CURRENT_MPS);
    return new SubCourse(
        List.of(
            List.of(new GateTask(gate, across, random.nextBoolean())),
            List.of(new BuoysTask(List.of(first, second), colours)),
            List.of(PingerTask.below(ring, seed)),
            List.of(new RingTask(ring))),
        speed * Math.sin(to),
        speed * Math.cos(to));
  }

  private static double between(Random random, double least, double most) {
    return least + (most - least) * random.nextDouble();
  }

  /** All tasks, in order. */
  List<CourseTask> tasks() {
    return stages.stream().flatMap(List::stream).collect(Collectors.toList());
  }

  /** All objects. */
  List<ObjectDescription> objects() {
    return tasks().stream().flatMap(task -> task.objects().stream()).collect(Collectors.toList());
  }

  /** The world of the run. */
  World world() {
    return World.at(ORIGIN).with(objects()).with(new Water(0.0, currentEastMps, currentNorthMps));
  }
}
