package org.u2sa.service.motion;

import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * Velocity over ground of a vehicle without lateral thrust due to wind and current. Immutable.
 *
 * @param northMps northward [m/s]
 * @param eastMps eastward [m/s]
 */
public record Drift(double northMps, double eastMps) {
  public static final Drift NONE = new Drift(0.0, 0.0);

  private static final double SLOWEST_MPS = 0.3; // through the water
  private static final double MAX_RAD = Math.toRadians(50.0);

  /**
   * Velocity over ground minus velocity through air or water; empty if a state lacks one of them,
   * or the heading.
   */
  public static Optional<Drift> measured(StateInformation state) {
    boolean isKnown =
        state.fluidxDot().isPresent()
            && state.psi().isPresent()
            && state.xDot().isPresent()
            && state.yDot().isPresent();
    if (!isKnown || state.referenceFrame().isBody()) {
      return Optional.empty();
    }
    boolean isEarth = state.referenceFrame().isEarth();
    StateInformation own = isEarth ? state : state.in(ReferenceFrame.LOCAL_NED);
    Attitude attitude =
        new Attitude(own.phi().orElse(0.0), own.theta().orElse(0.0), own.psi().orElseThrow());
    Point through =
        attitude.nedOf(
            Point.of(
                own.fluidxDot().orElseThrow(),
                own.fluidyDot().orElse(0.0),
                own.fluidzDot().orElse(0.0)));
    double x = own.xDot().orElseThrow();
    double y = own.yDot().orElseThrow();
    return Optional.of(new Drift((isEarth ? y : x) - through.x(), (isEarth ? x : y) - through.y()));
  }

  public double speedMps() {
    return Math.hypot(northMps, eastMps);
  }

  /** Part of the drift in a direction [m/s]. */
  public double towardsMps(double courseRad) {
    return northMps * Math.cos(courseRad) + eastMps * Math.sin(courseRad);
  }

  /**
   * Angle by which the bow must be to the right of a wanted course [rad].
   *
   * @param courseRad over ground, clockwise from north
   * @param aheadMps velocity over ground along the bow
   */
  public double crabRad(double courseRad, double aheadMps) {
    double right = eastMps * Math.cos(courseRad) - northMps * Math.sin(courseRad);
    double through = Math.max(SLOWEST_MPS, aheadMps - towardsMps(courseRad));
    double angle = -Math.asin(Math.max(-1.0, Math.min(1.0, right / through)));
    return Math.max(-MAX_RAD, Math.min(MAX_RAD, angle));
  }
}
