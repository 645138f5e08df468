package org.u2sa.planning.guidance;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.service.handover.HandOver;

/**
 * A position, on the earth or on a local plane, any coordinate of which may be absent. Immutable.
 *
 * @param onEarth true: x longitude and y latitude [deg]; false: x east and y north [m]
 * @param x see onEarth
 * @param y see onEarth
 * @param upM altitude above mean sea level, or above the local origin [m]
 */
public record Place(boolean onEarth, OptionalDouble x, OptionalDouble y, OptionalDouble upM) {
  /**
   * Position of a waypoint.
   *
   * @throws IllegalArgumentException if its frame moves with the vehicle
   */
  public static Place of(Waypoint waypoint) {
    return of(waypoint.referenceFrame(), waypoint.x(), waypoint.y(), waypoint.z());
  }

  /**
   * Position of a vehicle.
   *
   * @throws IllegalArgumentException if its frame moves with the vehicle
   */
  public static Place of(StateInformation state) {
    return of(state.referenceFrame(), state.x(), state.y(), state.z());
  }

  /** Position of a point in GLOBAL or LOCAL_NED. */
  public static Place of(ReferenceFrame frame, Point point) {
    return of(
        frame,
        OptionalDouble.of(point.x()),
        OptionalDouble.of(point.y()),
        OptionalDouble.of(point.z()));
  }

  private static Place of(
      ReferenceFrame frame, OptionalDouble x, OptionalDouble y, OptionalDouble z) {
    if (frame.equals(ReferenceFrame.GLOBAL)) {
      return new Place(true, x, y, z);
    }
    if (frame.equals(ReferenceFrame.LOCAL_ENU)) {
      return new Place(false, x, y, z);
    }
    if (frame.equals(ReferenceFrame.LOCAL_NED)) {
      return new Place(false, y, x, z.isPresent() ? OptionalDouble.of(-z.getAsDouble()) : z);
    }
    if (frame.isUtm() && x.isPresent() && y.isPresent()) {
      StateInformation global =
          new StateInformation()
              .referenceFrame(frame)
              .x(x.getAsDouble())
              .y(y.getAsDouble())
              .in(ReferenceFrame.GLOBAL);
      return new Place(true, global.x(), global.y(), z);
    }
    if (frame.isUtm() && x.isEmpty() && y.isEmpty()) {
      return new Place(true, x, y, z);
    }
    throw new IllegalArgumentException(
        "a position in "
            + frame
            + (frame.isUtm() ? " with x or y alone" : "")
            + " cannot be navigated to; expected GLOBAL, LOCAL_ENU, LOCAL_NED, or UTM with both");
  }

  /** Saves the position under a name for the service that takes over. */
  public void handOver(HandOver state, String name) {
    state.flag(name + " ON EARTH", onEarth);
    x.ifPresent(value -> state.number(name + " X", value));
    y.ifPresent(value -> state.number(name + " Y", value));
    upM.ifPresent(value -> state.number(name + " UP", value));
  }

  /** Position saved under a name; empty if none. */
  public static Optional<Place> takenOver(HandOver state, String name) {
    String onEarth = name + " ON EARTH";
    return state.names().contains(onEarth)
        ? Optional.of(
            new Place(
                state.flag(onEarth),
                state.number(name + " X"),
                state.number(name + " Y"),
                state.number(name + " UP")))
        : Optional.empty();
  }

  /** Copy at an altitude [m]. */
  public Place at(double altitudeM) {
    return new Place(onEarth, x, y, OptionalDouble.of(altitudeM));
  }

  /** A horizontal position away from this one, at the same altitude. */
  public Place moved(double northM, double eastM) {
    if (!onEarth) {
      return new Place(
          false,
          OptionalDouble.of(x.orElseThrow() + eastM),
          OptionalDouble.of(y.orElseThrow() + northM),
          upM);
    }
    Geodetic to =
        new Geodetic(x.orElseThrow(), y.orElseThrow(), 0.0).fromNed(Point.of(northM, eastM, 0.0));
    return new Place(
        true, OptionalDouble.of(to.longitudeDeg()), OptionalDouble.of(to.latitudeDeg()), upM);
  }

  public Place withoutAltitude() {
    return new Place(onEarth, x, y, OptionalDouble.empty());
  }

  /** Copy with the altitude of another position if this one has none. */
  public Place orAltitudeOf(Place other) {
    return upM.isPresent() ? this : new Place(onEarth, x, y, other.upM);
  }

  public boolean isHorizontal() {
    return x.isPresent() && y.isPresent();
  }
}
