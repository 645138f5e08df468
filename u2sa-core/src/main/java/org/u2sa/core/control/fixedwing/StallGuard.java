package org.u2sa.core.control.fixedwing;

/**
 * Keeps clear of the stall: the stall speed grows with the root of the load factor, 1/cos φ in a
 * level turn (14 CFR 23.2110; Cessna 172P handbook, figure 5-3).
 */
final class StallGuard {
  /**
   * @param stallSpeedMps calibrated, wings level, flaps up [m/s]
   * @param margin least airspeed over stall speed
   * @param bandMps above the least airspeed in which speed gets priority, step by step [m/s]
   * @param alphaLimitRad most angle of attack; above it the nose is lowered by the excess [rad]
   */
  record Parameters(double stallSpeedMps, double margin, double bandMps, double alphaLimitRad) {}

  private final Parameters parameters;

  StallGuard(Parameters parameters) {
    this.parameters = parameters;
  }

  /** Least calibrated airspeed at a bank [m/s]. */
  double leastSpeedMps(double bankRad) {
    double cosine = Math.max(0.1, StrictMath.cos(bankRad));
    return parameters.margin() * parameters.stallSpeedMps() / StrictMath.sqrt(cosine);
  }

  /** 0 with speed to spare … 1 at the least airspeed. */
  double urgency(FlightState state) {
    double spare = state.calibratedAirspeedMps() - leastSpeedMps(state.rollRad());
    return Limit.within(0.0, 1.0 - spare / parameters.bandMps(), 1.0);
  }

  /** Most bank that keeps the margin at the present airspeed [rad]. */
  double bankLimitRad(FlightState state) {
    double ratio =
        parameters.margin()
            * parameters.stallSpeedMps()
            / Math.max(1.0, state.calibratedAirspeedMps());
    return StrictMath.acos(Math.min(1.0, ratio * ratio));
  }

  /** Most pitch that keeps the angle of attack within its limit [rad]. */
  double pitchLimitRad(FlightState state) {
    return state.pitchRad() + parameters.alphaLimitRad() - state.alphaRad();
  }
}
