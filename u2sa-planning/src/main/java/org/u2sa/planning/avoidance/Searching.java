package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/**
 * Waits for a route; after a while, looks around for one. Gives up after {@code GIVE UP AFTER}.
 * Confined to the planner's thread.
 */
final class Searching implements Behaviour {
  /** A moving vehicle restarts its search, which may therefore not terminate. */
  private static final String NOT_IN_TIME = "no way to the goal was found in time";

  private static final double LOOK_STEP_RAD = Math.toRadians(60.0);
  private static final long LOOK_MICROS = 5 * Clock.MICROS_PER_SECOND / 2; // in each direction

  private final RouteKeeper routes;
  private long sinceMicros;
  private long turnedMicros = Long.MIN_VALUE;
  private double lookToRad;

  /**
   * @param sinceMicros time of the first step without a route [µs]
   */
  Searching(RouteKeeper routes, long sinceMicros) {
    this.routes = routes;
    this.sinceMicros = sinceMicros;
  }

  /** Whether it lasts so long that obstacles which are only guessed are to be ignored. */
  boolean doubtsObstacles(AvoidanceVariables settings, long micros) {
    return settings.overlookAfter() > 0.0 && micros - sinceMicros > settings.overlookMicros();
  }

  @Override
  public ArcChoice choose(ArcChooser arcs, Situation now) {
    AvoidanceVariables settings = now.settings();
    boolean looks =
        settings.overlookAfter() > 0.0
            && now.micros() - sinceMicros > 2 * settings.overlookMicros();
    return looks ? arcs.lookTo(lookToRad(now.pose(), now.micros())) : arcs.withoutRoute();
  }

  /** Heading in which to look for a route [rad]. */
  private double lookToRad(Pose pose, long micros) {
    if (turnedMicros == Long.MIN_VALUE || micros - turnedMicros > LOOK_MICROS) {
      turnedMicros = micros;
      lookToRad = Pose.wrapped(pose.headingRad() + LOOK_STEP_RAD);
    }
    return lookToRad;
  }

  @Override
  public void leaveOut(long micros) {
    sinceMicros += micros;
  }

  @Override
  public Optional<String> givesUp(Situation now) {
    if (now.micros() - sinceMicros < now.settings().giveUpMicros()) {
      return Optional.empty();
    }
    return Optional.of(routes.isSearching() ? NOT_IN_TIME : routes.obstacle());
  }

  @Override
  public boolean isStuck(Situation now) {
    return false;
  }
}
