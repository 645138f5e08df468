package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;
import org.u2sa.planning.local.RouteTrack;

/** Follows a route past traffic; a vehicle that can stop is stuck if it makes no progress. */
final class Following implements Behaviour {
  private final RouteTrack track;
  private final ProgressWatch watch; // progress toward the goal, on any route
  private final NearestYet nearest = new NearestYet();
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
    if (nearest.isNearer(track.remainingM(), now)) {
      nearestMicros = now.micros();
    }
    return now.settings().stops() && now.micros() - nearestMicros >= now.settings().stuckMicros();
  }
}
