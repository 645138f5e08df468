package org.u2sa.core.control.fixedwing;

import org.u2sa.service.HandOver;

/**
 * Ends a descent at the ground: the sink demanded falls with the height, ḣ = −h/τ, which is an
 * exponential flare (Stevens & Lewis, 2nd ed., section 4.7). The nose is raised until the sink is
 * that, in proportion and by an integral; once the wheels carry, it is let down.
 */
final class FlareLaw {
  /**
   * @param heightM above ground, at which the flare begins [m]
   * @param timeConstantS τ [s]
   * @param leastSinkMps at which the wheels are to touch [m/s]
   * @param damping pitch per difference of sink [rad s/m]
   * @param gain pitch rate per difference of sink [rad/m]
   * @param mostPitchRad so that the tail stays off the ground [rad]
   */
  record Parameters(
      double heightM,
      double timeConstantS,
      double leastSinkMps,
      double damping,
      double gain,
      double mostPitchRad) {}

  private static final double LEAST_PITCH_RAD = Math.toRadians(-2.0);
  private static final double LET_DOWN_RAD_PER_S = Math.toRadians(3.0);

  private final Parameters parameters;
  private double trimRad; // what the integral holds
  private double pitchRad;

  FlareLaw(Parameters parameters) {
    this.parameters = parameters;
  }

  /** Begins from a pitch. */
  void restart(double newPitchRad) {
    pitchRad = newPitchRad;
    trimRad = Double.NaN;
  }

  void handOver(HandOver state) {
    state.number("FLARE PITCH", pitchRad).number("FLARE TRIM", trimRad);
  }

  void takeOver(HandOver state) {
    pitchRad = state.number("FLARE PITCH").orElse(0.0);
    trimRad = state.number("FLARE TRIM").orElse(Double.NaN);
  }

  /** Height at which it begins [m]. */
  double heightM() {
    return parameters.heightM();
  }

  /** How much faster it sinks than it should at its height [m/s]. */
  double excessSinkMps(FlightState state) {
    double sink = Math.max(parameters.leastSinkMps(), state.heightM() / parameters.timeConstantS());
    return -sink - state.climbMps();
  }

  /** Pitch to hold [rad]. */
  double pitchRad(FlightState state, double dtS) {
    if (state.onGround()) {
      pitchRad = Limit.approach(pitchRad, 0.0, LET_DOWN_RAD_PER_S * dtS);
      return pitchRad;
    }
    double excess = excessSinkMps(state);
    double direct = parameters.damping() * excess;
    if (Double.isNaN(trimRad)) {
      trimRad = pitchRad - direct; // begins without a bump
    }
    trimRad =
        Limit.within(0.0, trimRad + parameters.gain() * excess * dtS, parameters.mostPitchRad());
    pitchRad = Limit.within(LEAST_PITCH_RAD, trimRad + direct, parameters.mostPitchRad());
    return pitchRad;
  }
}
