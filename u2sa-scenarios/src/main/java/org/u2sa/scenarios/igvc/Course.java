package org.u2sa.scenarios.igvc;

import java.util.List;
import java.util.function.Predicate;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.world.Ramp;
import org.u2sa.sim.world.RampedGround;
import org.u2sa.sim.world.Surface;
import org.u2sa.sim.world.Terrain;
import org.u2sa.sim.world.World;

/**
 * A course on a lawn: objects of a world XML file, east and north of its origin [m]. Object types
 * are those drawn by {@link Scenery}, and invisible ones: {@code lane boundary} (PolyLine: where
 * the judge counts a crossing, including gaps in the paint), {@code course end} (PolyLine: behind
 * the start and beyond the finish, not to be passed), {@code waypoint} (Circle with its radius, in
 * course order), {@code start} (Line: from the vehicle's position to a point ahead), {@code fence}
 * (PolyLine: the edge of the field, known to the vehicle beforehand).
 *
 * @param origin file or seed, for messages
 */
record Course(String origin, List<ObjectDescription> objects) {
  static final String BOUNDARY = "lane boundary";
  static final String END = "course end";
  static final String WAYPOINT = "waypoint";
  static final String START = "start";
  static final String FENCE = "fence";

  /** Width of a painted line: 3 in. */
  static final double LINE_M = 0.0762;

  /** Radius of a waypoint of the qualification. */
  static final double WAYPOINT_M = 2.0;

  /**
   * Start pose of the vehicle.
   *
   * @param headingRad heading, clockwise from north [rad]
   */
  record Start(double eastM, double northM, double headingRad) {}

  /** A waypoint to reach. */
  record Goal(String name, double eastM, double northM, double radiusM) {}

  /** A ramp and its name. */
  record NamedRamp(String uid, Ramp ramp) {}

  /**
   * @throws BadInputException if it has no start or no waypoint, an object is in another frame, or
   *     a ramp is invalid
   */
  Course {
    objects = List.copyOf(objects);
    for (ObjectDescription object : objects) {
      if (!object.referenceFrame().equals(ReferenceFrame.LOCAL_ENU)) {
        throw new BadInputException(
            origin
                + ": object \""
                + object.uid()
                + "\" is in "
                + object.referenceFrame()
                + "; a course is in Local ENU");
      }
    }
    require(origin, objects, START, o -> o instanceof Line line && line.points().size() >= 2);
    require(origin, objects, WAYPOINT, o -> o instanceof Circle);
    ramps(origin, objects);
  }

  private static List<NamedRamp> ramps(String origin, List<ObjectDescription> objects) {
    return objects.stream()
        .filter(object -> object.objectType().equals(Scenery.RAMP))
        .map(object -> new NamedRamp(object.uid(), ramp(origin, object)))
        .toList();
  }

  private static Ramp ramp(String origin, ObjectDescription object) {
    if (!(object instanceof PolyLine profile)) {
      throw new BadInputException(
          origin + ": object \"" + object.uid() + "\": expected a PolyLine, the ramp's profile");
    }
    try {
      return new Ramp(profile.points(), profile.width());
    } catch (IllegalArgumentException e) {
      throw new BadInputException(
          origin + ": object \"" + object.uid() + "\": " + e.getMessage(), e);
    }
  }

  private static void require(
      String origin,
      List<ObjectDescription> objects,
      String type,
      Predicate<ObjectDescription> asExpected) {
    List<ObjectDescription> found =
        objects.stream().filter(object -> object.objectType().equals(type)).toList();
    if (found.isEmpty() || !found.stream().allMatch(asExpected)) {
      throw new BadInputException(
          origin
              + ": "
              + (found.isEmpty() ? "no object" : "an object of another shape")
              + " has the type \""
              + type
              + "\"; expected "
              + (type.equals(START) ? "a Line of two points" : "Circles in order"));
    }
  }

  /** Start pose. */
  Start start() {
    Line line = (Line) of(START).get(0);
    Point from = line.points().get(0);
    Point to = line.points().get(1);
    double heading = StrictMath.atan2(to.x() - from.x(), to.y() - from.y());
    return new Start(from.x(), from.y(), heading < 0.0 ? heading + 2.0 * Math.PI : heading);
  }

  /** Waypoints, in order. */
  List<Goal> goals() {
    return of(WAYPOINT).stream()
        .map(object -> (Circle) object)
        .map(circle -> new Goal(circle.uid(), circle.x(), circle.y(), circle.radius()))
        .toList();
  }

  /** Ramps to drive over. */
  List<NamedRamp> ramps() {
    return ramps(origin, objects);
  }

  /** Lane boundaries on both sides. */
  List<PolyLine> boundaries() {
    return of(BOUNDARY).stream()
        .filter(PolyLine.class::isInstance)
        .map(PolyLine.class::cast)
        .toList();
  }

  /** Edges of the field, known to the vehicle; empty if the course has none. */
  List<PolyLine> fences() {
    return of(FENCE).stream().filter(PolyLine.class::isInstance).map(PolyLine.class::cast).toList();
  }

  /** Lines whose crossing the judge counts: boundaries and ends. */
  List<ObjectDescription> limits() {
    return objects.stream()
        .filter(PolyLine.class::isInstance)
        .filter(o -> o.objectType().equals(BOUNDARY) || o.objectType().equals(END))
        .toList();
  }

  /**
   * The world: a lawn with the ramps, and everything visible to a level laser, i.e. not paint.
   *
   * @param origin place of the course's origin on the earth
   */
  World world(Geodetic origin) {
    World lawn =
        World.at(origin)
            .with(
                objects.stream()
                    .filter(object -> object instanceof Cylinder || object instanceof Box)
                    .toList());
    List<Ramp> ramps = ramps().stream().map(NamedRamp::ramp).toList();
    if (ramps.isEmpty()) {
      return lawn;
    }
    RampedGround ground = new RampedGround(ramps);
    return lawn.with((Terrain) ground).with((Surface) ground);
  }

  /** All objects of a type, in order. */
  List<ObjectDescription> of(String type) {
    return objects.stream().filter(object -> object.objectType().equals(type)).toList();
  }
}
