package org.u2sa.control.cascade;

import java.util.Locale;
import java.util.Optional;
import org.u2sa.control.allocation.DegreeOfFreedom;

/**
 * Detects states that come too seldom or too late for the rate loops of a vehicle that leans: their
 * delay turns the loops' damping into oscillation. A loop of gain k, which crosses over at k rad/s,
 * loses k times the delay in phase (28 degrees at the limit here); rotors and filters need the rest
 * of its margin.
 */
final class StatePace {
  private static final double MAX_PHASE_RAD = 0.5;
  private static final double MEMORY_S = 2.0; // of the mean delay
  private static final DegreeOfFreedom[] LEANING = {DegreeOfFreedom.ROLL, DegreeOfFreedom.PITCH};

  private double seenS;
  private double delayS;
  private boolean isLate;

  /**
   * Processes a state.
   *
   * @param stepS time since the state before [s]; 0 for the first one
   * @param ageS age of the state [s]
   * @return a warning when the delay becomes too long; empty text when it no longer is
   */
  Optional<String> step(CascadeVariables tuning, double stepS, double ageS) {
    double share = stepS / (MEMORY_S + stepS);
    delayS += share * (stepS + Math.max(0.0, ageS) - delayS);
    seenS += stepS;
    DegreeOfFreedom quickest = quickest(tuning);
    double gain = tuning.of(quickest).gains().gain();
    double mostS = MAX_PHASE_RAD / Math.max(MAX_PHASE_RAD, gain);
    boolean isLateNow = seenS > 2.0 * MEMORY_S && delayS > mostS;
    if (isLateNow == isLate) {
      return Optional.empty();
    }
    isLate = isLateNow;
    return Optional.of(
        isLate
            ? String.format(
                Locale.ROOT,
                "states come too seldom or too late for %s GAIN %.1f 1/s: interval and age are"
                    + " %.0f ms together, above %.0f ms the vehicle may oscillate",
                quickest.name(),
                gain,
                1e3 * delayS,
                1e3 * mostS)
            : "");
  }

  private static DegreeOfFreedom quickest(CascadeVariables tuning) {
    DegreeOfFreedom quickest = LEANING[0];
    for (DegreeOfFreedom axis : LEANING) {
      boolean isQuicker = tuning.of(axis).gains().gain() > tuning.of(quickest).gains().gain();
      quickest = isQuicker ? axis : quickest;
    }
    return quickest;
  }
}
