package org.u2sa.control.fixedwing.law;

import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.service.handover.HandOver;

/**
 * Holds a pitch by the elevator: proportional pitch loop around a rate loop. In a turn, the pitch
 * rate of the coordinated turn q = g/V · sin φ tan φ (McCormick, Aerodynamics, Aeronautics, and
 * Flight Mechanics, section 7) is added to the demand.
 */
public final class PitchLaw {
  /** Variables of the pitch loop and its inner pitch-rate loop. */
  public record Variables(
      @Variable(unit = "s", min = 0.2, max = 5, ifAbsent = 0.8, text = "Pitch-error time constant.")
          double pitchTimeConstant,
      @Variable(
              unit = "deg/s",
              min = 1,
              max = 30,
              ifAbsent = 10,
              text = "Maximum pitch rate demanded for a pitch error.")
          double pitchRateLimit,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 0.5, text = "Elevator per pitch rate.")
          double pitchRateForwardGain,
      @Variable(
              unit = "s/rad",
              min = 0,
              max = 5,
              ifAbsent = 0.18,
              text = "Elevator per pitch-rate error.")
          double pitchRateGain,
      @Variable(
              unit = "1/rad",
              min = 0,
              max = 5,
              ifAbsent = 0.7,
              text = "Elevator per integrated pitch-rate error.")
          double pitchRateIntegralGain,
      @Variable(min = 0, max = 1, ifAbsent = 0.6, text = "Maximum elevator of the integral.")
          double elevatorTrimLimit) {}

  private static final double STEEPEST_RAD =
      Math.toRadians(60.0); // maximum bank that is compensated
  private static final double SLOWEST_MPS = 5.0;

  private final Variables parameters;
  private final RateLoop loop;

  /** Starts with an empty integrator. */
  public PitchLaw(Variables parameters) {
    this.parameters = parameters;
    this.loop =
        new RateLoop(
            new RateLoop.Gains(
                parameters.pitchRateForwardGain(),
                parameters.pitchRateGain(),
                parameters.pitchRateIntegralGain(),
                parameters.elevatorTrimLimit()));
  }

  /** Elevator, −1…1, positive lowers the nose. */
  public double elevator(FlightState state, double pitchRad, double scale, double dtS) {
    double error = pitchRad - state.pitchRad();
    double rate =
        Limit.symmetric(
            error / parameters.pitchTimeConstant(), Math.toRadians(parameters.pitchRateLimit()));
    return -loop.step(rate + turnRate(state), state.pitchRate(), scale, dtS);
  }

  /** Pitch rate of a coordinated turn at the current bank [rad/s]. */
  public static double turnRate(FlightState state) {
    double bank = Limit.symmetric(state.rollRad(), STEEPEST_RAD);
    double speed = Math.max(SLOWEST_MPS, state.trueAirspeedMps());
    return Gravity.STANDARD_MPS2 / speed * StrictMath.sin(bank) * StrictMath.tan(bank);
  }

  /** Clears the integrator. */
  public void restart() {
    loop.restart(0.0);
  }

  /** Starts bumplessly at a surface position. */
  public void restart(double surface) {
    loop.restart(-surface);
  }

  /** Stores the state of its integrators for a successor. */
  public void handOver(HandOver state) {
    state.number("PITCH INTEGRAL", loop.integral());
  }

  /** Continues from the state that a predecessor stored; resets without one. */
  public void takeOver(HandOver state) {
    state.number("PITCH INTEGRAL").ifPresent(loop::restart);
  }
}
