package org.u2sa.scenarios.igvc;

import java.util.List;
import java.util.function.Predicate;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Line;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.sim.camera.Scenery;
import org.u2sa.sim.world.Ramp;

/**
 * A course on a lawn: objects of a world XML file, east and north of its origin [m]. Types say what
 * they are: those that {@link Scenery} draws, and what nobody sees: {@code lane boundary}
 * (PolyLine: where the judge calls a crossing, gaps in the paint included), {@code course end}
 * (PolyLine: behind the start and beyond the finish, where nobody passes), {@code waypoint} (Circle
 * with its radius, in the order of the course), {@code start} (Line: from the vehicle's place to
 * somewhere ahead), {@code fence} (PolyLine: the edge of the field, which the vehicle is told
 * beforehand).
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
   * Where the vehicle stands at first.
   *
   * @param headingRad clockwise from north
   */
  record Start(double eastM, double northM, double headingRad) {}

  /** A place to go to. */
  record Goal(String name, double eastM, double northM, double radiusM) {}

  /** A ramp and its name. */
  record NamedRamp(String uid, Ramp ramp) {}

  /**
   * @throws BadInputException if it has no start or no waypoint, something is in another frame, or
   *     a ramp is none
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

  /** Where the vehicle starts. */
  Start start() {
    Line line = (Line) of(START).get(0);
    Point from = line.points().get(0);
    Point to = line.points().get(1);
    double heading = StrictMath.atan2(to.x() - from.x(), to.y() - from.y());
    return new Start(from.x(), from.y(), heading < 0.0 ? heading + 2.0 * Math.PI : heading);
  }

  /** Where it goes, in order. */
  List<Goal> goals() {
    return of(WAYPOINT).stream()
        .map(object -> (Circle) object)
        .map(circle -> new Goal(circle.uid(), circle.x(), circle.y(), circle.radius()))
        .toList();
  }

  /** What is to be driven over. */
  List<NamedRamp> ramps() {
    return ramps(origin, objects);
  }

  /** Where lanes end, to both sides. */
  List<PolyLine> boundaries() {
    return of(BOUNDARY).stream()
        .filter(PolyLine.class::isInstance)
        .map(PolyLine.class::cast)
        .toList();
  }

  /** The edge of the field, as the vehicle is told; none where a course does not say. */
  List<PolyLine> fences() {
    return of(FENCE).stream().filter(PolyLine.class::isInstance).map(PolyLine.class::cast).toList();
  }

  /** What the judge calls crossings of: boundaries and ends. */
  List<ObjectDescription> limits() {
    return objects.stream()
        .filter(PolyLine.class::isInstance)
        .filter(o -> o.objectType().equals(BOUNDARY) || o.objectType().equals(END))
        .toList();
  }

  /** Everything of one type, in order. */
  List<ObjectDescription> of(String type) {
    return objects.stream().filter(object -> object.objectType().equals(type)).toList();
  }
}
