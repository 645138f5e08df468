package org.u2sa.planning.avoidance;

import java.util.Optional;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.local.ArcChooser;

/**
 * Backs a stuck vehicle out for some time; then searches for another route from there. Confined to
 * the planner's thread.
 */
final class BackingOut implements Behaviour {
  private static final double WAY_RADII = 1.5; // radii of the vehicle

  private final long untilMicros;
  private final Searching search;

  /**
   * @param search what follows; its time has begun, too
   */
  BackingOut(long untilMicros, Searching search) {
    this.untilMicros = untilMicros;
    this.search = search;
  }

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

  @Override
  public boolean isStuck(Situation now) {
    return false;
  }
}
