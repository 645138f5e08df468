package org.u2sa.planning.guidance;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;

/**
 * Monitors whether a vehicle that can stop still comes nearer to a waypoint beside which it is, as
 * one does not that is too low for it or stops before it. Confined to the planner's thread.
 */
public final class ApproachWatch {
  private static final double BESIDE_M = 1.0; // or within the horizontal threshold
  private static final double STEP_M = 0.1; // a smaller change is an estimation error
  private static final double PATIENCE_S = 20.0;

  private double nearestM;
  private long cameNearerMicros;

  /** Begins a waypoint. */
  public void begin() {
    nearestM = Double.POSITIVE_INFINITY;
  }

  /**
   * Processes a state.
   *
   * @param besideM horizontal distance from the waypoint [m]
   * @param offM difference from its altitude, 0 if that does not matter [m], not negative
   * @param thresholdM its horizontal threshold [m]
   * @return why to give the waypoint up; empty if there is no reason
   */
  public Optional<String> step(double besideM, double offM, double thresholdM, long nowMicros) {
    double distanceM = Math.hypot(besideM, offM);
    boolean isBeside = besideM <= Math.max(BESIDE_M, thresholdM);
    if (!isBeside || distanceM < nearestM - STEP_M) {
      nearestM = distanceM;
      cameNearerMicros = nowMicros;
    }
    double waitsS = Clock.seconds(nowMicros - cameNearerMicros);
    return waitsS <= PATIENCE_S
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "no nearer for %.0f s, %.2f m beside it and %.1f m off its altitude",
                waitsS,
                besideM,
                offM));
  }
}
