package org.u2sa.core.planning;

import java.util.List;
import org.u2sa.core.planning.curve.Pose;
import org.u2sa.core.planning.local.ArcChoice;
import org.u2sa.core.planning.seen.Mover;
import org.u2sa.interfaces.time.Clock;

/**
 * Time in which traffic holds the vehicle up: it waits, or backs off before someone who comes
 * slowly head-on. That is no reason to give a goal up, so it does not count as time without
 * progress. Belongs to the planner's thread.
 */
final class TrafficHold {
  /** One who walks to and fro before the vehicle for longer is in the way for good [s]. */
  private static final double PATIENCE_S = 300.0;

  private long lastMicros;
  private long heldMicros; // for this goal

  /** The way to another goal begins. */
  void begin(long micros) {
    lastMicros = micros;
    heldMicros = 0;
  }

  /**
   * Takes the next moment.
   *
   * @return how much of the time since the last one traffic has taken [µs]
   */
  long pass(ArcChoice.Kind kind, boolean isNear, long micros) {
    long since = micros - lastMicros;
    lastMicros = micros;
    boolean holds =
        isNear && kind != ArcChoice.Kind.FOLLOW && heldMicros < Clock.micros(PATIENCE_S);
    long held = holds ? since : 0L;
    heldMicros += held;
    return held;
  }

  /**
   * Whether traffic can be where the vehicle is within a time.
   *
   * @param keptM beyond the traffic's own radius [m]
   */
  static boolean isNear(List<Mover> movers, Pose at, double keptM, double withinS, long nowMicros) {
    for (Mover mover : movers) {
      double age = mover.ageS(nowMicros);
      double away = at.distanceM(mover.northAfterM(age), mover.eastAfterM(age));
      double reach = Math.hypot(mover.northMps(), mover.eastMps()) * withinS;
      if (away < mover.radiusM() + keptM + reach) {
        return true;
      }
    }
    return false;
  }
}
