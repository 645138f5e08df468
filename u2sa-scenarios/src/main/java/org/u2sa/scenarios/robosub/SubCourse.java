package org.u2sa.scenarios.robosub;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Buoy;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Hoop;
import org.u2sa.messages.marine.Pole;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.World;

/**
 * A layout. Places are north, east and down of the start, which faces north at the surface [m].
 *
 * @param left gate's red pole
 * @param middle gate's white pole, which divides it
 * @param right gate's green pole
 * @param isLeft whether to pass on the side of the red pole
 * @param buoys places of the buoys, in the order in which to bump them
 * @param colours their colours
 * @param ring middle of the floating ring
 * @param currentEastMps of the water
 * @param currentNorthMps of the water
 */
record SubCourse(
    Point left,
    Point middle,
    Point right,
    boolean isLeft,
    List<Point> buoys,
    List<Colour> colours,
    Point ring,
    double currentEastMps,
    double currentNorthMps) {
  /** Place of the layout's start. */
  static final Geodetic ORIGIN = new Geodetic(-117.25, 32.7, 0.0);

  /** Radius of the ring [m]: an octagon of 9 feet. */
  static final double RING_M = 1.37;

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
    boolean isRedFirst = random.nextBoolean();
    Point ring =
        Point.of(
            second.x() + between(random, 5.0, 8.0), second.y() + between(random, -2.5, 2.5), 0.0);
    double to = between(random, -Math.PI, Math.PI);
    double speed = between(random, 0.0, MAX_CURRENT_MPS);
    return new SubCourse(
        gate.minus(across),
        gate,
        gate.plus(across),
        random.nextBoolean(),
        List.of(first, second),
        isRedFirst ? List.of(Colour.RED, Colour.GREEN) : List.of(Colour.GREEN, Colour.RED),
        ring,
        speed * Math.sin(to),
        speed * Math.cos(to));
  }

  private static double between(Random random, double least, double most) {
    return least + (most - least) * random.nextDouble();
  }

  /** Type of an object, such as "red buoy". */
  static String type(Colour colour, String kind) {
    return colour.name().toLowerCase(java.util.Locale.ROOT) + " " + kind;
  }

  /** Pole of the side to pass on. */
  Point pole() {
    return isLeft ? left : right;
  }

  /** All objects. */
  List<ObjectDescription> objects() {
    List<ObjectDescription> objects = new ArrayList<>();
    objects.add(pole(Colour.RED, left));
    objects.add(pole(Colour.WHITE, middle));
    objects.add(pole(Colour.GREEN, right));
    for (int i = 0; i < buoys.size(); i++) {
      objects.add(
          placed(
              new Buoy().colour(colours.get(i)).radius(0.15),
              type(colours.get(i), "buoy"),
              buoys.get(i)));
    }
    objects.add(
        placed(
            new Hoop().radius(RING_M).thickness(0.08).lying(true).colour(Colour.YELLOW),
            "yellow hoop",
            ring));
    return objects;
  }

  private static ObjectDescription pole(Colour colour, Point at) {
    return placed(new Pole().colour(colour).radius(0.04).height(1.2), type(colour, "pole"), at);
  }

  private static ObjectDescription placed(ObjectDescription object, String type, Point at) {
    object
        .uid(type)
        .objectType(type)
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(at.y())
        .y(at.x())
        .z(-at.z())
        .level(ObjectLevel.AVOID_ALWAYS);
    object.freeze();
    return object;
  }

  /** The world of the run. */
  World world() {
    return World.at(ORIGIN).with(objects()).with(new Water(0.0, currentEastMps, currentNorthMps));
  }
}
