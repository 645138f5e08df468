package org.u2sa.control.fixedwing.law;

/**
 * Stall protection: stall speed grows with the root of the load factor, 1/cos φ in a level turn (14
 * CFR 23.2110; Cessna 172P handbook, figure 5-3).
 */
public final class StallGuard {
  private final GuidanceVariables parameters;

  /** Guards by the stall speed of these parameters. */
  public StallGuard(GuidanceVariables parameters) {
    this.parameters = parameters;
  }

  /** Minimum calibrated airspeed at a bank [m/s]. */
  public double leastSpeedMps(double bankRad) {
    double cosine = Math.max(0.1, StrictMath.cos(bankRad));
    return parameters.stallMargin() * parameters.stallSpeed() / StrictMath.sqrt(cosine);
  }

  /** Urgency: 0 with speed to spare … 1 at the minimum airspeed. */
  public double urgency(FlightState state) {
    double spare = state.calibratedAirspeedMps() - leastSpeedMps(state.rollRad());
    return Limit.within(0.0, 1.0 - spare / parameters.stallBand(), 1.0);
  }

  /** Maximum bank that keeps the margin at the current airspeed [rad]. */
  public double bankLimitRad(FlightState state) {
    double ratio =
        parameters.stallMargin()
            * parameters.stallSpeed()
            / Math.max(1.0, state.calibratedAirspeedMps());
    return StrictMath.acos(Math.min(1.0, ratio * ratio));
  }

  /** Maximum pitch that keeps the angle of attack within its limit [rad]. */
  public double pitchLimitRad(FlightState state) {
    return state.pitchRad() + Math.toRadians(parameters.angleOfAttackLimit()) - state.alphaRad();
  }
}
