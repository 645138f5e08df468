package org.u2sa.planning.guidance;

import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.planning.seen.PlanningPlane;

/**
 * A state estimate from the planner's view: position and motion of the vehicle, and relative
 * positions of points.
 */
public final class Vehicle {
  /** Below this speed the course is meaningless [m/s]. */
  private static final double SLOWEST_MPS = 0.3;

  private final StateInformation state; // in GLOBAL or LOCAL_NED
  private final Place place;

  private Vehicle(StateInformation state) {
    this.state = state;
    this.place = Place.of(state);
  }

  /** View of a state; empty if it lacks position or heading, or is in a frame of the vehicle. */
  public static Optional<Vehicle> of(StateInformation state) {
    if (state.x().isEmpty() || state.y().isEmpty() || state.psi().isEmpty()) {
      return Optional.empty();
    }
    ReferenceFrame frame = state.referenceFrame();
    if (frame.isBody()) {
      return Optional.empty();
    }
    if (frame.isUtm()) {
      return Optional.of(new Vehicle(state.in(ReferenceFrame.GLOBAL)));
    }
    if (frame.equals(ReferenceFrame.LOCAL_ENU)) {
      return Optional.of(new Vehicle(state.in(ReferenceFrame.LOCAL_NED)));
    }
    return Optional.of(new Vehicle(state));
  }

  /** Position on a plane: north, east, down [m]. */
  public Point on(PlanningPlane plane) {
    return plane.ned(
        state.referenceFrame(),
        Point.of(state.x().orElseThrow(), state.y().orElseThrow(), state.z().orElse(0.0)));
  }

  /** Timestamp of the state [µs]; 0 if unknown. */
  public long timestampMicros() {
    return state.timestamp().orElse(0L);
  }

  public Place place() {
    return place;
  }

  /** Ground velocity northward [m/s]; 0 if unknown. */
  public double northMps() {
    return (place.onEarth() ? state.yDot() : state.xDot()).orElse(0.0);
  }

  /** Ground velocity eastward [m/s]; 0 if unknown. */
  public double eastMps() {
    return (place.onEarth() ? state.xDot() : state.yDot()).orElse(0.0);
  }

  /** Velocity downward [m/s]; 0 if unknown. */
  public double downMps() {
    double z = state.zDot().orElse(0.0);
    return place.onEarth() ? -z : z;
  }

  /** Ground speed [m/s]; 0 if unknown. */
  public double speedMps() {
    return Math.hypot(northMps(), eastMps());
  }

  /** Heading [rad, clockwise from north]. */
  public double headingRad() {
    return state.psi().orElseThrow();
  }

  /** Turn rate, clockwise [rad/s]; 0 if unknown. */
  public double turnRadps() {
    return state.psiDot().orElse(0.0);
  }

  /** Course, or heading at low speed [rad, clockwise from north]. */
  public double courseRad() {
    return speedMps() > SLOWEST_MPS ? Math.atan2(eastMps(), northMps()) : headingRad();
  }

  /**
   * Vector from the vehicle to a position: north, east, down [m]. A coordinate missing from the
   * position or the vehicle counts as no difference (thesis 4.6.2.3). Down is the difference of
   * altitudes, without the earth's curvature.
   *
   * @throws IllegalArgumentException if one is on the earth and the other on a local plane
   */
  public Point nedOf(Place other) {
    if (other.onEarth() != place.onEarth()) {
      throw new IllegalArgumentException(
          "a place " + frameOf(other) + " cannot be navigated to by a state " + frameOf(place));
    }
    double x = place.x().orElseThrow();
    double y = place.y().orElseThrow();
    double down =
        place.upM().isPresent() && other.upM().isPresent()
            ? place.upM().getAsDouble() - other.upM().getAsDouble()
            : 0.0;
    double otherX = other.x().orElse(x);
    double otherY = other.y().orElse(y);
    if (!place.onEarth()) {
      return Point.of(otherY - y, otherX - x, down);
    }
    double altitude = place.upM().orElse(0.0);
    Point ned = new Geodetic(x, y, altitude).nedOf(new Geodetic(otherX, otherY, altitude));
    return Point.of(ned.x(), ned.y(), down);
  }

  private static String frameOf(Place place) {
    return place.onEarth()
        ? "on the earth (GLOBAL, UTM)"
        : "on a local plane (LOCAL_ENU, LOCAL_NED)";
  }

  /** Rotates north, east, down to BODY: forward, left, down; level if attitude is unknown. */
  public Point body(Point ned) {
    return body(ned, state.phi().orElse(0.0), state.theta().orElse(0.0));
  }

  /** Rotates BODY to north, east, down, as the inverse of {@link #body}. */
  public Point ned(Point body) {
    return new Attitude(state.phi().orElse(0.0), state.theta().orElse(0.0), headingRad())
        .nedOf(body);
  }

  /** Like {@link #body}, but for a level vehicle whatever its attitude. */
  Point levelBody(Point ned) {
    return body(ned, 0.0, 0.0);
  }

  private Point body(Point ned, double phi, double theta) {
    return new Attitude(phi, theta, headingRad()).bodyOf(ned);
  }
}
