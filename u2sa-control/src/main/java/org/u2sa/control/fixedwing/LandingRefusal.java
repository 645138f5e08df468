package org.u2sa.control.fixedwing;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.control.Transfer;

/**
 * Refuses to land in more crosswind than configured. After a refusal the aircraft stays airborne
 * until navigation leads up again, to where an approach begins: a new one needs a decision.
 */
final class LandingRefusal {
  /** Navigation below this height above ground means landing: no mission cruises this low [m]. */
  static final double LEADS_DOWN_M = 15.0;

  /**
   * Navigation above this height, or above the one to climb to, leads to the next approach. The
   * wind is evaluated once it leads below, where a climb is still easy [m].
   */
  private static final double LEADS_UP_M = 42.0;

  private static final double HYSTERESIS_M = 2.0; // that much lower

  /** Closer to the flare, a descent cannot become a climb before touchdown [m]. */
  private static final double COMMITTED_ABOVE_FLARE_M = 6.0;

  /** Upward acceleration that ends a descent [m/s²]. */
  private static final double PULL_UP_MPS2 = 2.0;

  private final double maxCrosswindMps;
  private final double safeHeightM;
  private final double committedHeightM;
  private boolean refused;
  private double crosswindMps; // at the refusal, positive if blowing to the right

  /**
   * @param safeHeightM height above ground to climb to instead [m]
   * @param flareHeightM height at which the flare starts, above ground [m]; slightly above it, a
   *     landing continues in any case
   */
  LandingRefusal(double maxCrosswindMps, double safeHeightM, double flareHeightM) {
    this.maxCrosswindMps = maxCrosswindMps;
    this.safeHeightM = safeHeightM;
    committedHeightM = flareHeightM + COMMITTED_ABOVE_FLARE_M;
  }

  /** Whether the aircraft must not land now. */
  boolean step(
      FlightState state,
      Optional<GuidanceTarget> target,
      WindEstimate wind,
      FinalApproach approach) {
    if (target.isEmpty()) {
      return refused;
    }
    double ledToM = target.get().altitudeM() - (state.altitudeM() - state.heightM());
    double leadsUpM = Math.min(safeHeightM, LEADS_UP_M);
    if (refused) {
      refused = ledToM < leadsUpM;
    } else if (ledToM < leadsUpM - HYSTERESIS_M
        && state.heightM() > committedHeightM + pullUpM(state)
        && approach.isKnown()) {
      crosswindMps = wind.acrossMps(approach.courseRad());
      refused = Math.abs(crosswindMps) > maxCrosswindMps;
    }
    return refused;
  }

  /** Height needed to end the descent [m]. */
  private static double pullUpM(FlightState state) {
    double sinkMps = Math.max(0.0, -state.climbMps());
    return sinkMps * sinkMps / (2.0 * PULL_UP_MPS2);
  }

  /** The reason, and what the aircraft does instead. */
  String words() {
    return String.format(
        Locale.ROOT,
        "not landing: %.1f m/s of wind from the %s across the approach, MAX CROSSWIND is %.1f m/s;"
            + " keeps %.0f m above ground until navigation leads higher",
        Math.abs(crosswindMps),
        crosswindMps > 0.0 ? "left" : "right",
        maxCrosswindMps,
        safeHeightM);
  }

  void transfer(Transfer state) {
    refused = state.flag("LANDING REFUSED", refused);
    crosswindMps = state.number("REFUSED CROSSWIND", crosswindMps);
  }
}
