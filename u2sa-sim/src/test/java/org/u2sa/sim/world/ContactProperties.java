package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Line;

/** Contacts against the distances of points strewn all over a footprint, where any is near. */
class ContactProperties {
  private static final double STEP_M = 0.02;

  @Property(tries = 1000)
  void contacts_anyPlaceAmongAnyObjects_areThoseThatPointsOfTheFootprintTouch(@ForAll long seed) {
    Random random = new Random(seed);
    List<ObjectDescription> objects = RayProperties.objects(random, 10);
    objects.add(
        new Line()
            .points(List.of(point(random), point(random), point(random)))
            .uid("line")
            .referenceFrame(ReferenceFrame.LOCAL_ENU)
            .x(0.0)
            .y(0.0));
    World world = RayProperties.LAWN.with(objects);
    double ahead = 0.2 + 0.5 * random.nextDouble();
    double behind = 0.1 + 0.2 * random.nextDouble();
    double width = 0.2 + 0.5 * random.nextDouble();
    Footprint footprint = Footprint.rectangle(ahead, behind, width, 0.1, 0.5);
    Point place = point(random);
    double heading = 7.0 * random.nextDouble();
    List<ObjectDescription> found = world.contacts(footprint, place, heading);
    Point middle = Point.of(place.x(), place.y(), place.z() + 0.3);
    double reachM = Math.hypot(Math.hypot(Math.max(ahead, behind), width / 2.0), 0.2);
    for (ObjectDescription object : objects) {
      if (distanceM(object, middle) > reachM + 3.0 * STEP_M) {
        assertThat(found).doesNotContain(object);
        continue;
      }
      double nearest = Double.POSITIVE_INFINITY;
      for (double a = -behind; a <= ahead; a += STEP_M) {
        for (double r = -width / 2.0; r <= width / 2.0; r += STEP_M) {
          for (double up = 0.1; up <= 0.5; up += STEP_M) {
            double east = place.x() + a * Math.sin(heading) + r * Math.cos(heading);
            double north = place.y() + a * Math.cos(heading) - r * Math.sin(heading);
            Point at = Point.of(east, north, place.z() + up);
            nearest = Math.min(nearest, distanceM(object, at));
          }
        }
      }
      if (nearest == 0.0) {
        assertThat(found).contains(object);
      } else if (nearest > 2.0 * STEP_M) {
        assertThat(found).doesNotContain(object);
      }
    }
  }

  private static double distanceM(ObjectDescription object, Point at) {
    boolean down = object.referenceFrame().equals(ReferenceFrame.LOCAL_NED);
    return object.distanceTo(down ? Point.of(at.y(), at.x(), -at.z()) : at);
  }

  private static Point point(Random random) {
    return Point.of(
        10.0 * (random.nextDouble() - 0.5),
        10.0 * (random.nextDouble() - 0.5),
        random.nextDouble());
  }
}
