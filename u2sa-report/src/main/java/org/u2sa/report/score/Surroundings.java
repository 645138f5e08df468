package org.u2sa.report.score;

import java.util.List;
import java.util.Map;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.Polygon;

/**
 * Ground truth of the static and moving objects of a run, whether known to the vehicle or not.
 * Objects of level HINDRANCE may be touched.
 *
 * @param objects in GLOBAL, UTM, or a local frame with its origin at the vehicle's start
 * @param reachM radius of the vehicle around its reference point [m]; nearer objects are touched
 * @param areas areas on the ground, for the map
 * @param shapes true shapes, by uid, of objects that are spheres on the map; used for distances
 */
public record Surroundings(
    List<ObjectDescription> objects,
    double reachM,
    List<Area> areas,
    Map<String, ObjectDescription> shapes) {
  /**
   * An area defined by the judge.
   *
   * @param outline its unique identifier is the area's name
   * @param isForbidden whether the vehicle must stay out of it
   */
  public record Area(Polygon outline, boolean isForbidden) {}

  public Surroundings {
    objects = List.copyOf(objects);
    areas = List.copyOf(areas);
    shapes = Map.copyOf(shapes);
  }

  /** Objects without areas. */
  public Surroundings(List<ObjectDescription> objects, double reachM) {
    this(objects, reachM, List.of(), Map.of());
  }

  /** No objects. */
  public static Surroundings none() {
    return new Surroundings(List.of(), 0.0);
  }

  /** Whether an object moves, according to its description. */
  public static boolean moves(ObjectDescription object) {
    boolean turns = object instanceof MovingSphere sphere && !sphere.trajectory().isEmpty();
    return turns || object.motion().velocity().filter(v -> !v.equals(Point.ORIGIN)).isPresent();
  }

  /**
   * Centre of an object at a time of the run [s], in its own frame. In global frames, an object
   * that moves straight keeps its altitude above sea level, except for its climb.
   */
  public static Point centreAfter(ObjectDescription object, double seconds) {
    if (!moves(object)) {
      return object.center();
    }
    if (object instanceof MovingSphere sphere && !sphere.trajectory().isEmpty()) {
      return sphere.centerAfter(seconds);
    }
    Point velocity = object.motion().velocity().orElseThrow();
    Point there = object.after(seconds).center();
    return object.referenceFrame().isEarth()
        ? Point.of(there.x(), there.y(), object.z() + velocity.z() * seconds)
        : there;
  }

  /** Object at a time of the run [s], without its further path. */
  public static ObjectDescription after(ObjectDescription object, double seconds) {
    if (!moves(object)) {
      return object;
    }
    ObjectDescription alone =
        object instanceof MovingSphere sphere
            ? ((MovingSphere) sphere.copy()).trajectory(List.of())
            : object;
    return alone.movedTo(centreAfter(object, seconds));
  }

  /** Distance of a position, in an object's frame, from the object at a time of the run [s]. */
  double distanceM(ObjectDescription object, double seconds, Point position) {
    ObjectDescription then = after(object, seconds);
    ObjectDescription shape = shapes.get(object.uid());
    return (shape == null ? then : shape.movedTo(then.center())).distanceTo(position);
  }

  /** Converts a position to an object's frame, for {@link ObjectDescription#distanceTo}. */
  static Point in(ObjectDescription object, Geodetic place, Geodetic home) {
    if (object.referenceFrame().isEarth()) {
      return object.referenceFrame().isUtm()
          ? new UtmGrid(object.referenceFrame()).grid(place)
          : place.point();
    }
    Point enu =
        home.enuOf(new Geodetic(place.longitudeDeg(), place.latitudeDeg(), home.altitudeM()));
    double upM = place.altitudeM() - home.altitudeM();
    return object.referenceFrame().equals(ReferenceFrame.LOCAL_NED)
        ? Point.of(enu.y(), enu.x(), -upM)
        : Point.of(enu.x(), enu.y(), upM);
  }

  /** Global position of a point in an object's frame: the inverse of {@link #in}. */
  public static Geodetic onEarth(ObjectDescription object, Point point, Geodetic home) {
    if (object.referenceFrame().isEarth()) {
      return Geodetic.of(UtmGrid.global(object.referenceFrame(), point));
    }
    boolean ned = object.referenceFrame().equals(ReferenceFrame.LOCAL_NED);
    return home.fromEnu(Point.of(ned ? point.y() : point.x(), ned ? point.x() : point.y(), 0.0));
  }
}
