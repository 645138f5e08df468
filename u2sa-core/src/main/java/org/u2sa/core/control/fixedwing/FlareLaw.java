package org.u2sa.core.control.fixedwing;

import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.HandOver;

/**
 * Ends a descent at the ground: the sink demanded falls with the height, ḣ = −h/τ, which is an
 * exponential flare (Stevens & Lewis, 2nd ed., section 4.7). The nose is raised until the sink is
 * that, in proportion and by an integral; once the wheels carry, it is let down.
 */
final class FlareLaw {
  /** Of the flare; it starts only where navigation leads to the ground. */
  record Parameters(
      @Variable(
              unit = "m",
              min = 1,
              max = 30,
              ifAbsent = 9,
              text =
                  "Height above ground at which the flare starts, if navigation leads to the ground.")
          double flareHeight,
      @Variable(
              unit = "s",
              min = 0.5,
              max = 10,
              ifAbsent = 4,
              text = "Flare time constant: the demanded sink rate is height over this time.")
          double flareTimeConstant,
      @Variable(unit = "m/s", min = 0.1, max = 2, ifAbsent = 0.5, text = "Sink rate at touchdown.")
          double flareSink,
      @Variable(unit = "rad s/m", min = 0, max = 1, ifAbsent = 0.04, text = "Pitch per sink error.")
          double flareDamping,
      @Variable(
              unit = "rad/m",
              min = 0.001,
              max = 1,
              ifAbsent = 0.03,
              text = "Pitch rate per sink-rate error.")
          double flareGain,
      @Variable(
              unit = "deg",
              min = 2,
              max = 14,
              ifAbsent = 10,
              text = "Maximum pitch in the flare: the tail clears the ground.")
          double flarePitchLimit) {}

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
    return parameters.flareHeight();
  }

  /** How much faster it sinks than it should at its height [m/s]. */
  double excessSinkMps(FlightState state) {
    double sink =
        Math.max(parameters.flareSink(), state.heightM() / parameters.flareTimeConstant());
    return -sink - state.climbMps();
  }

  /** Pitch to hold [rad]. */
  double pitchRad(FlightState state, double dtS) {
    if (state.onGround()) {
      pitchRad = Limit.approach(pitchRad, 0.0, LET_DOWN_RAD_PER_S * dtS);
      return pitchRad;
    }
    double excess = excessSinkMps(state);
    double direct = parameters.flareDamping() * excess;
    if (Double.isNaN(trimRad)) {
      trimRad = pitchRad - direct; // begins without a bump
    }
    double mostPitchRad = Math.toRadians(parameters.flarePitchLimit());
    trimRad = Limit.within(0.0, trimRad + parameters.flareGain() * excess * dtS, mostPitchRad);
    pitchRad = Limit.within(LEAST_PITCH_RAD, trimRad + direct, mostPitchRad);
    return pitchRad;
  }
}
