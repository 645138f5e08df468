package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * Flares at the end of a descent: the demanded sink rate falls with height, ḣ = −h/τ, an
 * exponential flare (Stevens &amp; Lewis, 2nd ed., section 4.7). A PI loop raises the nose to
 * attain that sink rate; after touchdown the nose is lowered.
 */
final class FlareLaw {
  /** Variables of the flare, which starts only if navigation leads to the ground. */
  record Variables(
      @Variable(unit = "m", min = 1, max = 30, ifAbsent = 9)
          @Description(
              "Height above ground at which the flare starts, if navigation leads to the ground.")
          double flareHeight,
      @Variable(unit = "s", min = 0.5, max = 10, ifAbsent = 4)
          @Description("Flare time constant: the demanded sink rate is height over this time.")
          double flareTimeConstant,
      @Variable(unit = "m/s", min = 0.1, max = 2, ifAbsent = 0.5)
          @Description("Sink rate at touchdown.")
          double flareSink,
      @Variable(unit = "rad s/m", min = 0, max = 1, ifAbsent = 0.04)
          @Description("Pitch per sink error.")
          double flareDamping,
      @Variable(unit = "rad/m", min = 0.001, max = 1, ifAbsent = 0.03)
          @Description("Pitch rate per sink-rate error.")
          double flareGain,
      @Variable(unit = "deg", min = 2, max = 14, ifAbsent = 10)
          @Description("Maximum pitch in the flare: the tail clears the ground.")
          double flarePitchLimit) {}

  private static final double MIN_PITCH_RAD = Math.toRadians(-2.0);
  private static final double LET_DOWN_RAD_PER_S = Math.toRadians(3.0);

  private final Variables parameters;
  private double trimRad; // integral
  private double pitchRad;

  FlareLaw(Variables parameters) {
    this.parameters = parameters;
  }

  void restart(double newPitchRad) {
    pitchRad = newPitchRad;
    trimRad = Double.NaN;
  }

  void transfer(Transfer state) {
    pitchRad = state.number("FLARE PITCH", pitchRad);
    trimRad = state.number("FLARE TRIM", trimRad, Double.NaN);
  }

  /** Height at which the flare starts [m]. */
  double heightM() {
    return parameters.flareHeight();
  }

  /** Excess sink rate over the one demanded at this height [m/s]. */
  double excessSinkMps(FlightState state) {
    return -wantedSinkMps(state) - state.climbMps();
  }

  /** Sink rate demanded at this height [m/s]. */
  double wantedSinkMps(FlightState state) {
    return Math.max(parameters.flareSink(), state.heightM() / parameters.flareTimeConstant());
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
      trimRad = pitchRad - direct; // bumpless start
    }
    double mostPitchRad = Math.toRadians(parameters.flarePitchLimit());
    trimRad = Limit.within(0.0, trimRad + parameters.flareGain() * excess * dtS, mostPitchRad);
    pitchRad = Limit.within(MIN_PITCH_RAD, trimRad + direct, mostPitchRad);
    return pitchRad;
  }
}
