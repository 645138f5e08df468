package org.u2sa.control.fixedwing.law;

import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.handover.HandOver;

/** Holds a bank by the ailerons: proportional bank loop around a rate loop. */
public final class RollLaw {
  /** Variables of the bank loop and its inner roll-rate loop. */
  public record Variables(
      @Variable(unit = "s", min = 0.2, max = 5, ifAbsent = 0.65, text = "Bank-error time constant.")
          double bankTimeConstant,
      @Variable(unit = "deg/s", min = 2, max = 60, ifAbsent = 20, text = "Maximum roll rate.")
          double rollRateLimit,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 1.1, text = "Aileron per roll rate.")
          double rollRateForwardGain,
      @Variable(
              unit = "s/rad",
              min = 0,
              max = 5,
              ifAbsent = 0.2,
              text = "Aileron per roll-rate error.")
          double rollRateGain,
      @Variable(
              unit = "1/rad",
              min = 0,
              max = 5,
              ifAbsent = 0.1,
              text = "Aileron per integrated roll-rate error.")
          double rollRateIntegralGain,
      @Variable(min = 0, max = 1, ifAbsent = 0.4, text = "Maximum aileron of the integral.")
          double aileronTrimLimit) {}

  private final Variables parameters;
  private final RateLoop loop;

  /** Starts with an empty integrator. */
  public RollLaw(Variables parameters) {
    this.parameters = parameters;
    this.loop =
        new RateLoop(
            new RateLoop.Gains(
                parameters.rollRateForwardGain(),
                parameters.rollRateGain(),
                parameters.rollRateIntegralGain(),
                parameters.aileronTrimLimit()));
  }

  /** Aileron, −1…1, positive rolls right. */
  public double aileron(FlightState state, double bankRad, double scale, double dtS) {
    double error = Limit.angle(bankRad - state.rollRad());
    double rate =
        Limit.symmetric(
            error / parameters.bankTimeConstant(), Math.toRadians(parameters.rollRateLimit()));
    return loop.step(rate, state.rollRate(), scale, dtS);
  }

  /** Clears the integrator. */
  public void restart() {
    loop.restart(0.0);
  }

  /** Starts bumplessly at a surface position. */
  public void restart(double surface) {
    loop.restart(surface);
  }

  /** Stores the state of its integrators for a successor. */
  public void handOver(HandOver state) {
    state.number("ROLL INTEGRAL", loop.integral());
  }

  /** Continues from the state that a predecessor stored; resets without one. */
  public void takeOver(HandOver state) {
    state.number("ROLL INTEGRAL").ifPresent(loop::restart);
  }
}
