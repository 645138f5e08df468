package org.u2sa.core.control.fixedwing;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.service.HandOver;

/**
 * Holds a pitch by the elevator: proportional pitch loop around a rate loop. In a turn the nose
 * must keep coming round, so the rate of the coordinated turn q = g/V · sin φ tan φ (McCormick,
 * Aerodynamics, Aeronautics, and Flight Mechanics, section 7) is demanded beside.
 */
final class PitchLaw {
  /**
   * @param timeConstantS of the pitch error [s]
   * @param rateLimit most pitch rate demanded for the error [rad/s]
   * @param rate the inner loop
   */
  record Parameters(double timeConstantS, double rateLimit, RateLoop.Gains rate) {}

  private static final double STEEPEST_RAD =
      Math.toRadians(60.0); // of the turn that is compensated
  private static final double SLOWEST_MPS = 20.0;

  private final Parameters parameters;
  private final RateLoop loop;

  PitchLaw(Parameters parameters) {
    this.parameters = parameters;
    this.loop = new RateLoop(parameters.rate());
  }

  /** Elevator, −1…1, positive lowers the nose. */
  double elevator(FlightState state, double pitchRad, double scale, double dtS) {
    double error = pitchRad - state.pitchRad();
    double rate = Limit.symmetric(error / parameters.timeConstantS(), parameters.rateLimit());
    return -loop.step(rate + turnRate(state), state.pitchRate(), scale, dtS);
  }

  static double turnRate(FlightState state) {
    double bank = Limit.symmetric(state.rollRad(), STEEPEST_RAD);
    double speed = Math.max(SLOWEST_MPS, state.trueAirspeedMps());
    return Gravity.STANDARD_MPS2 / speed * StrictMath.sin(bank) * StrictMath.tan(bank);
  }

  void restart() {
    loop.restart(0.0);
  }

  /** Starts with a surface held. */
  void restart(double surface) {
    loop.restart(-surface);
  }

  void handOver(HandOver state) {
    state.number("PITCH INTEGRAL", loop.integral());
  }

  void takeOver(HandOver state) {
    state.number("PITCH INTEGRAL").ifPresent(loop::restart);
  }
}
