package org.u2sa.planning.seen;

import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Plane on which paths are planned: north, east, down [m] from an origin on the earth, or from the
 * origin of the local frames. Immutable.
 *
 * <p>Down is the difference of altitudes, without the earth's curvature.
 */
public final class PlanningPlane {
  private final Geodetic origin; // null for local frames

  private PlanningPlane(Geodetic origin) {
    this.origin = origin;
  }

  /**
   * Plane of the local frames if the state is in one, otherwise tangent to the earth at the
   * vehicle.
   */
  public static PlanningPlane at(StateInformation state) {
    if (state.referenceFrame().isLocal()) {
      return new PlanningPlane(null);
    }
    StateInformation global = state.in(ReferenceFrame.GLOBAL);
    return new PlanningPlane(
        new Geodetic(global.x().orElseThrow(), global.y().orElseThrow(), global.z().orElse(0.0)));
  }

  /** Whether it is for positions on the earth rather than in local frames. */
  public boolean onEarth() {
    return origin != null;
  }

  /**
   * Converts a point to the plane: north, east, down [m].
   *
   * @throws IllegalArgumentException if the frame cannot be mapped to it
   */
  public Point ned(ReferenceFrame frame, Point point) {
    if (origin != null && frame.equals(ReferenceFrame.GLOBAL)) {
      Point flat = origin.nedOf(new Geodetic(point.x(), point.y(), origin.altitudeM()));
      return Point.of(flat.x(), flat.y(), origin.altitudeM() - point.z());
    }
    if (origin == null && frame.equals(ReferenceFrame.LOCAL_NED)) {
      return point;
    }
    if (origin == null && frame.equals(ReferenceFrame.LOCAL_ENU)) {
      return Point.of(point.y(), point.x(), -point.z());
    }
    throw new IllegalArgumentException(
        "a point in "
            + frame
            + " does not lie on a plane "
            + (origin == null ? "of local frames" : "on the earth"));
  }

  /** Frame of the results of {@link #point}. */
  public ReferenceFrame frame() {
    return origin == null ? ReferenceFrame.LOCAL_NED : ReferenceFrame.GLOBAL;
  }

  /** Converts a position on the plane to {@link #frame}. */
  public Point point(double northM, double eastM, double downM) {
    if (origin == null) {
      return Point.of(northM, eastM, downM);
    }
    Geodetic place = origin.fromNed(Point.of(northM, eastM, 0.0));
    return Point.of(place.longitudeDeg(), place.latitudeDeg(), origin.altitudeM() - downM);
  }

  /** Frame to which objects in the vehicle's own axes or in UTM must be converted first. */
  ReferenceFrame frameFor(ReferenceFrame frame) {
    if (frame.equals(frame()) || (origin == null && frame.equals(ReferenceFrame.LOCAL_ENU))) {
      return frame;
    }
    return frame();
  }
}
