package org.u2sa.sim.marine;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Dock;
import org.u2sa.messages.shape.Box;
import org.u2sa.sim.world.Footprint;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.sim.world.World;

/**
 * The padded walls of a world's docks, against which a hull can lie: a spring and a damper wherever
 * a corner of the hull is inside a wall, or a wall's corner inside the hull, and friction along the
 * wall. Forces are horizontal; roll and pitch are ignored. Places are east, north, up; velocities
 * level.
 */
final class Fenders {
  private static final double SPRING_N_PER_M = 3_000.0;
  private static final double DAMPER_NS_PER_M = 300.0;
  private static final double FRICTION = 0.2; // friction coefficient of wet rubber
  private static final double SLIDES_MPS =
      0.05; // sliding speed at which friction is fully developed

  private final List<Wall> walls = new ArrayList<>();
  private final Footprint footprint;
  private final List<Point> hull; // ahead, right [m]
  private final double reachM; // of the hull

  /** Heights are above the world's origin [m]. */
  private record Wall(ConvexOutline outline, double lowM, double highM) {}

  /** Motion of a hull: position [m], heading, velocity over ground, turn rate; clockwise. */
  record Motion(Point place, double headingRad, Point velocity, double turnRadps) {
    Point worldOf(Point body) {
      double sin = StrictMath.sin(headingRad);
      double cos = StrictMath.cos(headingRad);
      return Point.of(
          place.x() + body.x() * sin + body.y() * cos,
          place.y() + body.x() * cos - body.y() * sin,
          0.0);
    }

    /** Velocity of a point fixed to the hull. */
    Point velocityAt(Point at) {
      return Point.of(
          velocity.x() + turnRadps * (at.y() - place.y()),
          velocity.y() - turnRadps * (at.x() - place.x()),
          0.0);
    }
  }

  Fenders(World world, Footprint footprint) {
    this.footprint = footprint;
    hull = footprint.corners();
    reachM = hull.stream().mapToDouble(each -> Math.hypot(each.x(), each.y())).max().orElseThrow();
    for (ObjectDescription object : world.obstacles()) {
      if (object instanceof Dock dock) {
        dock.walls().forEach(wall -> walls.add(wall(wall, world.plane())));
      }
    }
  }

  private static Wall wall(Box wall, LocalPlane plane) {
    boolean isEarth = wall.referenceFrame().isEarth();
    Box placed = (Box) wall.in(isEarth ? ReferenceFrame.GLOBAL : ReferenceFrame.LOCAL_ENU, null);
    Point centre = isEarth ? plane.point(Geodetic.of(placed.center())) : placed.center();
    Point middle = Point.of(centre.x(), centre.y(), 0.0);
    double psi = isEarth ? Math.PI / 2.0 - placed.psi() : placed.psi();
    double cos = StrictMath.cos(psi);
    double sin = StrictMath.sin(psi);
    Point along = Point.of(cos, sin, 0.0).times(wall.length() / 2.0);
    Point across = Point.of(-sin, cos, 0.0).times(wall.width() / 2.0);
    ConvexOutline outline =
        ConvexOutline.of(
            List.of(
                middle.plus(along).plus(across),
                middle.minus(along).plus(across),
                middle.minus(along).minus(across),
                middle.plus(along).minus(across)));
    double half = wall.height() / 2.0;
    return new Wall(outline, centre.z() - half, centre.z() + half);
  }

  boolean isEmpty() {
    return walls.isEmpty();
  }

  /** Force on the hull: X, Y [N], N [N m] about its reference point. */
  Point on(Motion motion) {
    double[] push = new double[3]; // east, north, clockwise
    if (walls.stream().anyMatch(wall -> isNear(wall, motion.place()))) {
      ConvexOutline lying =
          ConvexOutline.of(
              hull.stream().map(motion::worldOf).collect(Collectors.toUnmodifiableList()));
      for (Wall wall : walls) {
        if (!isNear(wall, motion.place())) {
          continue;
        }
        for (Point corner : lying.corners()) {
          wall.outline().wayOut(corner).ifPresent(out -> press(motion, corner, out, push));
        }
        for (Point corner : wall.outline().corners()) {
          lying.wayOut(corner).ifPresent(out -> press(motion, corner, out.times(-1.0), push));
        }
      }
    }
    double sin = StrictMath.sin(motion.headingRad());
    double cos = StrictMath.cos(motion.headingRad());
    return Point.of(push[0] * sin + push[1] * cos, push[0] * cos - push[1] * sin, push[2]);
  }

  private boolean isNear(Wall wall, Point place) {
    Point corner = wall.outline().corners().get(0);
    double span = corner.distanceTo(wall.outline().corners().get(2));
    return place.z() + footprint.bottomM() < wall.highM()
        && place.z() + footprint.topM() > wall.lowM()
        && corner.distanceTo(Point.of(place.x(), place.y(), 0.0)) < span + reachM;
  }

  /**
   * Adds the force at a point of the hull.
   *
   * @param out displacement that would free the hull
   */
  private static void press(Motion motion, Point at, Point out, double[] push) {
    Point velocity = motion.velocityAt(at);
    double depth = Math.max(out.distance(), 1e-9);
    Point normal = out.times(1.0 / depth);
    double away = velocity.x() * normal.x() + velocity.y() * normal.y();
    double force = Math.max(0.0, SPRING_N_PER_M * depth - DAMPER_NS_PER_M * away);
    Point slide = velocity.minus(normal.times(away));
    double drag = FRICTION * force / Math.max(SLIDES_MPS, slide.distance());
    double east = force * normal.x() - drag * slide.x();
    double north = force * normal.y() - drag * slide.y();
    push[0] += east;
    push[1] += north;
    push[2] += east * (at.y() - motion.place().y()) - north * (at.x() - motion.place().x());
  }
}
