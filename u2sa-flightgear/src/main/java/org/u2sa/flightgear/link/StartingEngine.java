package org.u2sa.flightgear.link;

import org.u2sa.sim.aircraft.ControlInputs;

/**
 * Control limits of FlightGear's c172p while its primer works, about 7 s: throttle 0.1…0.5 and rich
 * mixture; outside them the engine stops permanently.
 */
final class StartingEngine {
  static final double LOWEST_THROTTLE = 0.1;
  static final double HIGHEST_THROTTLE = 0.5;

  private static final double MARGIN = 0.02;

  private StartingEngine() {}

  /** Limits controls to values that keep the engine running. */
  static ControlInputs safe(ControlInputs wanted) {
    double throttle =
        Math.max(LOWEST_THROTTLE + MARGIN, Math.min(HIGHEST_THROTTLE - MARGIN, wanted.throttle()));
    return wanted.withThrottle(throttle).withMixture(1.0);
  }

  /** Whether these controls keep the engine running. */
  static boolean survives(ControlInputs controls) {
    return controls.throttle() >= LOWEST_THROTTLE
        && controls.throttle() <= HIGHEST_THROTTLE
        && controls.mixture() > 0.5;
  }
}
