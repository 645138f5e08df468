package org.u2sa.planning.avoidance;

import java.util.List;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.goals.PursuitTime;
import org.u2sa.planning.guidance.Vehicle;
import org.u2sa.planning.local.ArcChoice;
import org.u2sa.planning.seen.Mover;

/**
 * Measures the time that does not count as lack of progress: the vehicle may not move, or traffic
 * blocks it, so that it waits or backs off from slow oncoming traffic. Confined to the planner's
 * thread.
 */
final class TrafficHold {
  /** Maximum hold; longer blockage by traffic counts as permanent [s]. */
  private static final double PATIENCE_S = 300.0;

  private long lastMicros;
  private long lastPursued;
  private long heldMicros;

  /**
   * @param micros time [µs]
   * @param pursued {@link PursuitTime} [µs]
   */
  TrafficHold(long micros, long pursued) {
    lastMicros = micros;
    lastPursued = pursued;
  }

  /**
   * Updates the hold at a new time.
   *
   * @param pursued {@link PursuitTime} [µs]
   * @return part of the time since the last call that was lost [µs]
   */
  long pass(ArcChoice.Kind kind, boolean isNear, long micros, long pursued) {
    long since = micros - lastMicros;
    long able = pursued - lastPursued;
    lastMicros = micros;
    lastPursued = pursued;
    boolean holds =
        isNear && kind != ArcChoice.Kind.FOLLOW && heldMicros < Clock.micros(PATIENCE_S);
    heldMicros += holds ? able : 0L;
    return holds ? since : since - able;
  }

  /** Whether traffic comes near a vehicle that moves straight on, within the given time. */
  static boolean comesNear(
      List<Mover> movers, Vehicle vehicle, Point at, double keptM, double withinS) {
    for (Mover mover : movers) {
      double age = mover.ageS(vehicle.timestampMicros());
      double north = mover.northAfterM(age) - at.x();
      double east = mover.eastAfterM(age) - at.y();
      double northMps = mover.northMps() - vehicle.northMps();
      double eastMps = mover.eastMps() - vehicle.eastMps();
      double square = northMps * northMps + eastMps * eastMps;
      double nearestS = square == 0.0 ? 0.0 : -(north * northMps + east * eastMps) / square;
      double then = Math.max(0.0, Math.min(withinS, nearestS));
      if (Math.hypot(north + then * northMps, east + then * eastMps) < mover.radiusM() + keptM) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether traffic can reach the vehicle within the given time.
   *
   * @param keptM clearance beyond the traffic's own radius [m]
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
