package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/** Waits for a route, or circles if the vehicle cannot stop; after a while looks around for one. */
final class Searching implements Behaviour {
  private static final long CIRCLES_AFTER = 3 * Clock.MICROS_PER_SECOND;

  private final RouteKeeper routes;
  private final LookingAround looking = new LookingAround();
  private long sinceMicros; // first step without a route

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
    return lasts(now.settings(), now.micros(), 2) ? looking.choose(arcs, now) : arcs.withoutRoute();
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
