package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.messages.shape.Sphere;

/**
 * Rays against a march that knows nothing of boxes and quadratics: it walks by each shape's own
 * distance, as the messages give it, so that it cannot step through any.
 */
class RayProperties {
  private static final double RANGE_M = 30.0;
  private static final double NEAR = 1e-6;
  private static final double GRAZING_M = 1e-7; // what passes nearer than this may count as a hit
  static final World LAWN = World.at(new Geodetic(11.0, 48.0, 500.0));

  /** Objects at random, some of them in each frame of the world. */
  static List<ObjectDescription> objects(Random random, int count) {
    List<ObjectDescription> objects = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double size = 0.2 + 2.0 * random.nextDouble();
      ObjectDescription object =
          switch (random.nextInt(4)) {
            case 0 -> new Cylinder().radius(size).height(2.0 * random.nextDouble());
            case 1 -> new Sphere().radius(size);
            case 2 -> new Polygon().points(star(random, size)).height(3.0 * random.nextDouble());
            default ->
                new Box()
                    .length(size)
                    .width(3.0 * random.nextDouble())
                    .height(3.0 * random.nextDouble())
                    .psi(7.0 * random.nextDouble());
          };
      boolean down = random.nextBoolean();
      double z = 2.0 * random.nextDouble();
      objects.add(
          object
              .uid("object " + i)
              .referenceFrame(down ? ReferenceFrame.LOCAL_NED : ReferenceFrame.LOCAL_ENU)
              .x(30.0 * (random.nextDouble() - 0.5))
              .y(30.0 * (random.nextDouble() - 0.5))
              .z(down ? -z : z));
    }
    return objects;
  }

  /** Corners of a star, convex or not, anywhere. */
  private static List<Point> star(Random random, double size) {
    double x = 30.0 * (random.nextDouble() - 0.5);
    double y = 30.0 * (random.nextDouble() - 0.5);
    List<Point> corners = new ArrayList<>();
    int count = 3 + random.nextInt(6);
    for (int i = 0; i < count; i++) {
      double angle = 2.0 * Math.PI * (i + 0.5 * random.nextDouble()) / count;
      double reach = size * (0.3 + random.nextDouble());
      corners.add(Point.of(x + reach * Math.cos(angle), y + reach * Math.sin(angle), 0.0));
    }
    return corners;
  }

  private static double distanceM(ObjectDescription object, Point enu) {
    return object.distanceTo(
        object.referenceFrame().equals(ReferenceFrame.LOCAL_NED)
            ? Point.of(enu.y(), enu.x(), -enu.z())
            : enu);
  }

  private static double marched(List<ObjectDescription> objects, Terrain terrain, Ray ray) {
    for (double along = 0.0; along <= RANGE_M; ) {
      Point at = ray.at(along);
      double ground = at.z() - terrain.heightM(at.x(), at.y());
      double free = ground / Math.hypot(1.0, terrain.steepest());
      for (ObjectDescription object : objects) {
        free = Math.min(free, distanceM(object, at));
      }
      if (free < GRAZING_M) {
        return along;
      }
      along += free;
    }
    return Double.POSITIVE_INFINITY;
  }

  @Property(tries = 300)
  void distanceM_anyRayAmongAnyObjects_isWhatAMarchFinds(@ForAll long seed) {
    Random random = new Random(seed);
    Terrain terrain =
        switch (random.nextInt(3)) {
          case 0 -> Terrain.flat();
          case 1 -> Terrain.slope(0.2 * random.nextDouble(), 6.0 * random.nextDouble());
          default -> Terrain.hill(3.0, -2.0, 4.0 + 20.0 * random.nextDouble(), 0.3);
        };
    List<ObjectDescription> objects = objects(random, random.nextInt(12));
    World world = LAWN.with(terrain).with(objects);
    for (int i = 0; i < 20; i++) {
      Point from =
          Point.of(
              20.0 * (random.nextDouble() - 0.5),
              20.0 * (random.nextDouble() - 0.5),
              5.0 * random.nextDouble());
      Ray ray = Ray.of(from, 7.0 * random.nextDouble(), 0.5 * random.nextGaussian());
      double found = world.distanceM(ray, RANGE_M);
      double expected = marched(objects, terrain, ray);
      if (Double.isInfinite(found) && Double.isFinite(expected)) {
        assertGrazed(objects, terrain, ray, expected);
      } else if (Double.isFinite(found)) {
        // The march stops where it is within 0.1 µm: up to 1 mm early along a grazing ray.
        assertThat(expected).isLessThanOrEqualTo(found + NEAR).isGreaterThan(found - 5e-3);
        assertThat(free(objects, terrain, ray.at(found))).isCloseTo(0.0, within(NEAR));
      }
      assertThat(
              world.cast(ray, RANGE_M).map(World.Hit::distanceM).orElse(Double.POSITIVE_INFINITY))
          .isEqualTo(found);
    }
  }

  private static double free(List<ObjectDescription> objects, Terrain terrain, Point at) {
    double free = Math.max(0.0, at.z() - terrain.heightM(at.x(), at.y()));
    for (ObjectDescription object : objects) {
      free = Math.min(free, distanceM(object, at));
    }
    return free;
  }

  /** Fails if the ray is ever inside something. */
  private static void assertGrazed(
      List<ObjectDescription> objects, Terrain terrain, Ray ray, double near) {
    for (double along = near - 1e-2; along < near + 1e-2; along += 1e-5) {
      Point at = ray.at(Math.max(0.0, along));
      assertThat(free(objects, terrain, at)).as("%s at %s", ray, along).isPositive();
    }
  }
}
