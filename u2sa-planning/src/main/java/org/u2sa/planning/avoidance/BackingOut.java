package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/**
 * Backs a stuck vehicle out for some time, or drives it ahead; then searches for another route from
 * there.
 *
 * @param search the state that follows; its time has already begun
 * @param isAhead drives ahead only
 */
record BackingOut(long untilMicros, Searching search, boolean isAhead) implements Behaviour {
  private static final double WAY_RADII = 1.5; // radii of the vehicle

  /** The state at a time [µs]: this one or the search that follows. */
  Behaviour at(long micros) {
    return micros < untilMicros ? this : search;
  }

  @Override
  public ArcChoice choose(ArcChooser arcs, Situation now) {
    double wayM = WAY_RADII * now.body().circleM();
    return isAhead ? arcs.ahead(wayM) : arcs.backOut(wayM);
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
