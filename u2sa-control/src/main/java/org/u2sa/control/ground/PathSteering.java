package org.u2sa.control.ground;

import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;

/** Stanley's law along the path traced by the navigation points. Not thread-safe. */
final class PathSteering {
  private static final double FAR_M = 10_000.0; // beyond this the origin is moved, for precision

  private static final double AWAY_RAD = Math.toRadians(75.0);

  private final TargetTrail trail = new TargetTrail();
  private StateInformation origin; // null if none yet

  /** Angle of the front wheels [rad], left positive; empty without target, position or path. */
  OptionalDouble steeringRad(
      StanleyLaw.Variables tuning,
      StateInformation state,
      Optional<GroundTarget> target,
      double wheelbaseM,
      GroundControl.Measured measured) {
    if (target.isEmpty() || state.psi().isEmpty() || !GroundTarget.hasPlace(state)) {
      trail.clear();
      return OptionalDouble.empty();
    }
    Point place = place(state);
    double heading = state.psi().getAsDouble();
    double cos = Math.cos(heading);
    double sin = Math.sin(heading);
    GroundTarget to = target.get();
    Point point = // left is −90° of the heading
        Point.of(
            place.x() + to.forwardM() * cos + to.leftM() * sin,
            place.y() + to.forwardM() * sin - to.leftM() * cos,
            0.0);
    trail.see(point, place);
    Point front = Point.of(place.x() + wheelbaseM * cos, place.y() + wheelbaseM * sin, 0.0);
    Optional<TargetTrail.Beside> beside = trail.beside(front);
    if (beside.isPresent() && leadsAway(beside.get(), heading, to)) {
      trail.clear(); // a corner was missed: start a leg here
      trail.see(point, place);
      beside = trail.beside(front);
    }
    if (beside.isEmpty()) {
      return OptionalDouble.empty();
    }
    double headingError = Math.IEEEremainder(heading - beside.get().headingRad(), 2.0 * Math.PI);
    return OptionalDouble.of(
        StanleyLaw.steeringRad(
            tuning,
            headingError,
            beside.get().rightM(),
            measured.forwardMps().orElse(0.0),
            measured.yawRateRadPerS().orElse(0.0)));
  }

  private static boolean leadsAway(
      TargetTrail.Beside path, double headingRad, GroundTarget target) {
    double towards = headingRad - target.bearingRad();
    return Math.abs(Math.IEEEremainder(towards - path.headingRad(), 2.0 * Math.PI)) > AWAY_RAD;
  }

  private Point place(StateInformation state) {
    boolean isOther = origin == null || !origin.referenceFrame().equals(state.referenceFrame());
    Point place = isOther ? Point.ORIGIN : GroundTarget.displacement(origin, state);
    if (isOther || place.distance() > FAR_M) {
      origin = state;
      trail.clear();
      return Point.ORIGIN;
    }
    return place;
  }
}
