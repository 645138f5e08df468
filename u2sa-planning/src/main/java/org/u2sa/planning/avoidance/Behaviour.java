package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.RouteTrack;

/** State of a {@link GoalAttempt}: the vehicle's current way of reaching its goal. */
sealed interface Behaviour {
  ArcChoice choose(ArcChooser arcs, Situation now);

  /** Excludes time in which traffic blocked the vehicle [µs]. */
  void leaveOut(long micros);

  /** Reason for giving up the goal, or empty. */
  Optional<String> givesUp(Situation now);

  /** Whether the vehicle has to free itself; called once a step. */
  default boolean isStuck(Situation now) {
    return false;
  }

  /** Follows a route past traffic; a vehicle that can stop is stuck if it makes no progress. */
  final class Following implements Behaviour {
    private final RouteTrack track;
    private final ProgressWatch watch; // progress toward the goal on whichever route
    private double nearestM = Double.POSITIVE_INFINITY; // shortest remaining route so far
    private long nearestMicros;

    Following(RouteTrack track, ProgressWatch watch) {
      this.track = track;
      this.watch = watch;
    }

    boolean isAlong(RouteTrack route) {
      return route == track;
    }

    @Override
    public ArcChoice choose(ArcChooser arcs, Situation now) {
      return arcs.along(track);
    }

    @Override
    public void leaveOut(long micros) {
      nearestMicros += micros;
    }

    @Override
    public Optional<String> givesUp(Situation now) {
      return watch.circles(track.remainingM(), now);
    }

    @Override
    public boolean isStuck(Situation now) {
      double remaining = track.remainingM();
      if (remaining < nearestM - now.progressM()) {
        nearestM = remaining;
        nearestMicros = now.micros();
      }
      return now.settings().stops() && now.micros() - nearestMicros >= now.settings().stuckMicros();
    }
  }

  /** Waits for a route, and after a while looks around for one. */
  final class Searching implements Behaviour {
    private static final double LOOK_STEP_RAD = Math.toRadians(60.0);
    private static final long CIRCLES_AFTER = 3 * Clock.MICROS_PER_SECOND;
    private static final long LOOK_MICROS = 5 * Clock.MICROS_PER_SECOND / 2; // in each direction

    private final RouteKeeper routes;
    private long sinceMicros; // first step without a route
    private long turnedMicros = Long.MIN_VALUE;
    private double lookToRad;

    Searching(RouteKeeper routes, long sinceMicros) {
      this.routes = routes;
      this.sinceMicros = sinceMicros;
    }

    /** Whether it has lasted long enough to ignore inferred obstacles. */
    boolean doubtsObstacles(AvoidanceVariables settings, long micros) {
      return lasts(settings, micros, 1);
    }

    private boolean lasts(AvoidanceVariables settings, long micros, int times) {
      return settings.overlookAfter() > 0.0
          && micros - sinceMicros > times * settings.overlookMicros();
    }

    @Override
    public ArcChoice choose(ArcChooser arcs, Situation now) {
      if (!now.settings().stops() && now.micros() - sinceMicros > CIRCLES_AFTER) {
        return arcs.circle();
      }
      if (!lasts(now.settings(), now.micros(), 2)) {
        return arcs.withoutRoute();
      }
      if (turnedMicros == Long.MIN_VALUE || now.micros() - turnedMicros > LOOK_MICROS) {
        turnedMicros = now.micros();
        lookToRad = Pose.wrapped(now.pose().headingRad() + LOOK_STEP_RAD);
      }
      return arcs.lookTo(lookToRad);
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
      // a moving vehicle restarts its search, which may therefore not terminate
      return Optional.of(
          routes.isSearching() ? "no way to the goal was found in time" : routes.obstacle());
    }
  }

  /**
   * Backs a stuck vehicle out for some time; then searches for another route from there.
   *
   * @param search the state that follows; its time has already begun
   */
  record BackingOut(long untilMicros, Searching search) implements Behaviour {
    private static final double WAY_RADII = 1.5; // radii of the vehicle

    /** The state at a time [µs]: this one or the search that follows. */
    Behaviour at(long micros) {
      return micros < untilMicros ? this : search;
    }

    @Override
    public ArcChoice choose(ArcChooser arcs, Situation now) {
      return arcs.backOut(WAY_RADII * now.body().circleM());
    }

    @Override
    public void leaveOut(long micros) {
      search.leaveOut(micros);
    }

    @Override
    public Optional<String> givesUp(Situation now) {
      return search.givesUp(now);
    }
  }
}
