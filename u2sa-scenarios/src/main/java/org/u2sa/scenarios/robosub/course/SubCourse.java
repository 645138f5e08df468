package org.u2sa.scenarios.robosub.course;

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
 * A layout. Positions are north, east and down from the start at the surface [m], which faces
 * north.
 *
 * @param stages tasks in order; those of one stage may be done in any order (thesis, figure 21)
 * @param currentEastMps eastward current
 * @param currentNorthMps northward current
 */
public record SubCourse(
    List<List<CourseTask>> stages, double currentEastMps, double currentNorthMps) {
  /** Place of the layout's start. */
  public static final Geodetic ORIGIN = new Geodetic(-117.25, 32.7, 0.0);

  private static final double SIDE_M = 1.5; // width of each side of the gate: 10 feet for both
  static final double FLOOR_M = 3.7; // depth
  private static final double MAX_CURRENT_MPS = 0.05;

  /** Generates the layout for a seed; each marker on the floor points to the tasks beyond it. */
  public static SubCourse of(long seed) {
    Random random = new Random(seed * 0x9E3779B97F4A7C15L);
    Walk walk = new Walk(random);
    walk.turn(-0.35, 0.35);
    walk.to(Point.of(between(random, 5.0, 8.0), between(random, -2.0, 2.0), 0.0));
    Point gate = walk.at(0.0, 0.0, between(random, 1.3, 2.0));
    CourseTask first = new GateTask(gate, walk.right(SIDE_M), random.nextBoolean());

    walk.ahead(2.5, 4.0);
    Point marker = walk.at(0.0, between(random, -0.7, 0.7), FLOOR_M);
    walk.turn(0.4, 1.2, random.nextBoolean());
    CourseTask toBuoys = new MarkerTask("first path marker", marker, walk.headingRad());

    walk.to(marker);
    walk.ahead(6.0, 8.0);
    Point near = walk.at(0.0, between(random, -1.2, 1.2), between(random, 1.3, 2.5));
    walk.to(near);
    walk.ahead(3.0, 4.5);
    double side = random.nextBoolean() ? 1.0 : -1.0;
    Point far = walk.at(0.0, side * between(random, 1.2, 2.0), between(random, 1.3, 2.5));
    CourseTask buoys = new BuoysTask(List.of(near, far), colours(random));

    walk.to(far);
    walk.ahead(2.5, 4.0);
    Point last = walk.at(0.0, between(random, -0.7, 0.7), FLOOR_M);
    walk.turn(-0.7, 0.7);
    CourseTask onwards = new MarkerTask("second path marker", last, walk.headingRad());

    walk.to(last);
    double bins = between(random, 6.0, 8.0);
    double binsAside = side * between(random, 1.5, 2.5);
    Point bin = walk.at(bins, binsAside - 0.75, FLOOR_M - 0.1);
    Point otherBin = walk.at(bins, binsAside + 0.75, FLOOR_M - 0.1);
    boolean isLeftBin = random.nextBoolean();
    CourseTask drop =
        new BinTask(isLeftBin ? bin : otherBin, isLeftBin ? otherBin : bin, colours(random), seed);

    double hoops = between(random, 8.0, 10.0);
    double hoopsAside = -side * between(random, 1.5, 2.5);
    double downM = between(random, 2.0, 2.6);
    Point hoop = walk.at(hoops, hoopsAside - 0.6, downM);
    Point otherHoop = walk.at(hoops, hoopsAside + 0.6, downM);
    boolean isLeftHoop = random.nextBoolean();
    CourseTask shoot =
        new TorpedoTask(
            isLeftHoop ? hoop : otherHoop,
            isLeftHoop ? otherHoop : hoop,
            walk.headingRad() + between(random, -0.25, 0.25),
            colours(random),
            seed);

    Point ring = walk.at(between(random, 13.0, 16.0), between(random, -2.0, 2.0), 0.0);
    double to = between(random, -Math.PI, Math.PI);
    double speed = between(random, 0.0, MAX_CURRENT_MPS);
    return new SubCourse(
        List.of(
            List.of(first),
            List.of(toBuoys),
            List.of(buoys),
            List.of(onwards),
            List.of(drop, shoot),
            List.of(PingerTask.below(ring, seed)),
            List.of(new RingTask(ring))),
        speed * Math.sin(to),
        speed * Math.cos(to));
  }

  /** Red and green, in random order. */
  private static List<Colour> colours(Random random) {
    return random.nextBoolean()
        ? List.of(Colour.RED, Colour.GREEN)
        : List.of(Colour.GREEN, Colour.RED);
  }

  static double between(Random random, double least, double most) {
    return least + (most - least) * random.nextDouble();
  }

  /** All tasks, in order. */
  List<CourseTask> tasks() {
    return stages.stream().flatMap(List::stream).collect(Collectors.toList());
  }

  public List<ObjectDescription> objects() {
    return tasks().stream().flatMap(task -> task.objects().stream()).collect(Collectors.toList());
  }

  /** The world of the run. */
  public World world() {
    return World.at(ORIGIN).with(objects()).with(new Water(0.0, currentEastMps, currentNorthMps));
  }
}
