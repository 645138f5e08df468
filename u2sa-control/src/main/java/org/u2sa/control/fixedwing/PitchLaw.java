package org.u2sa.control.fixedwing;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Gravity;

/**
 * Holds a pitch by the elevator: proportional pitch loop around a rate loop. In a turn, the pitch
 * rate of the coordinated turn q = g/V · sin φ tan φ (McCormick, Aerodynamics, Aeronautics, and
 * Flight Mechanics, section 7) is added to the demand.
 */
final class PitchLaw extends RateLoop {
  /** Variables of the pitch loop and its inner pitch-rate loop. */
  record Variables(
      @Variable(unit = "s", min = 0.2, max = 5, ifAbsent = 0.8)
          @Description("Pitch-error time constant.")
          double pitchTimeConstant,
      @Variable(unit = "deg/s", min = 1, max = 30, ifAbsent = 10)
          @Description("Maximum pitch rate demanded for a pitch error.")
          double pitchRateLimit,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 0.5)
          @Description("Elevator per pitch rate.")
          double pitchRateForwardGain,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 0.18)
          @Description("Elevator per pitch-rate error.")
          double pitchRateGain,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 0.7)
          @Description("Elevator per integrated pitch-rate error.")
          double pitchRateIntegralGain,
      @Variable(min = 0, max = 1, ifAbsent = 0.6) @Description("Maximum elevator by the integral.")
          double elevatorTrimLimit) {}

  private static final double STEEPEST_RAD = Math.toRadians(60.0); // maximum bank to compensate
  private static final double SLOWEST_MPS = 5.0;

  private final Variables parameters;

  PitchLaw(Variables parameters) {
    super(
        "PITCH INTEGRAL",
        new Gains(
            parameters.pitchRateForwardGain(),
            parameters.pitchRateGain(),
            parameters.pitchRateIntegralGain(),
            parameters.elevatorTrimLimit()));
    this.parameters = parameters;
  }

  /** Elevator, −1…1, positive lowers the nose. */
  double elevator(FlightState state, double pitchRad, double scale, double dtS) {
    double error = pitchRad - state.pitchRad();
    double rate =
        Limit.symmetric(
            error / parameters.pitchTimeConstant(), Math.toRadians(parameters.pitchRateLimit()));
    return -step(rate + turnRate(state), state.pitchRate(), scale, dtS);
  }

  /** Pitch rate of a coordinated turn at the current bank [rad/s]. */
  static double turnRate(FlightState state) {
    double bank = Limit.symmetric(state.rollRad(), STEEPEST_RAD);
    double speed = Math.max(SLOWEST_MPS, state.trueAirspeedMps());
    return Gravity.STANDARD_MPS2 / speed * StrictMath.sin(bank) * StrictMath.tan(bank);
  }
}
