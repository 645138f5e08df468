package org.u2sa.report.score;

import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.MovingSphere;

/**
 * What truly stands and moves around in a run, whatever the vehicle knows of it.
 *
 * @param objects in GLOBAL, UTM, or a local frame about the vehicle's first place
 * @param reachM from the vehicle's reference point to where it ends [m]: an object nearer than that
 *     is touched
 */
public record Surroundings(List<ObjectDescription> objects, double reachM) {
  public Surroundings {
    objects = List.copyOf(objects);
  }

  /** Nothing. */
  public static Surroundings none() {
    return new Surroundings(List.of(), 0.0);
  }

  /** Whether an object moves, as far as its description goes. */
  public static boolean moves(ObjectDescription object) {
    boolean turns = object instanceof MovingSphere sphere && !sphere.trajectory().isEmpty();
    return turns || object.motion().velocity().filter(v -> !v.equals(Point.ORIGIN)).isPresent();
  }

  /**
   * The centre of an object when so many seconds of the run have passed, in its own frame. What
   * moves straight on over the earth keeps its height above the sea, but for its climb.
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

  /** The object as it is after so many seconds of the run. */
  public static ObjectDescription after(ObjectDescription object, double seconds) {
    return moves(object) ? object.movedTo(centreAfter(object, seconds)) : object;
  }

  /** A place in the frame of an object, as {@link ObjectDescription#distanceTo} takes it. */
  static Point in(ObjectDescription object, Geodetic place, Geodetic home) {
    if (object.referenceFrame().isEarth()) {
      return place.point();
    }
    Point enu =
        home.enuOf(new Geodetic(place.longitudeDeg(), place.latitudeDeg(), home.altitudeM()));
    double upM = place.altitudeM() - home.altitudeM();
    return object.referenceFrame().equals(ReferenceFrame.LOCAL_NED)
        ? Point.of(enu.y(), enu.x(), -upM)
        : Point.of(enu.x(), enu.y(), upM);
  }

  /** A place on the earth of a point in an object's frame: the way back of {@link #in}. */
  public static Geodetic onEarth(ObjectDescription object, Point point, Geodetic home) {
    if (object.referenceFrame().isEarth()) {
      return Geodetic.of(point);
    }
    boolean ned = object.referenceFrame().equals(ReferenceFrame.LOCAL_NED);
    return home.fromEnu(Point.of(ned ? point.y() : point.x(), ned ? point.x() : point.y(), 0.0));
  }
}
