package org.u2sa.control.fixedwing;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/** Holds a bank by the ailerons: proportional bank loop around a rate loop. */
final class RollLaw extends RateLoop {
  /** Variables of the bank loop and its inner roll-rate loop. */
  record Variables(
      @Variable(unit = "s", min = 0.2, max = 5, ifAbsent = 0.65)
          @Description("Bank-error time constant.")
          double bankTimeConstant,
      @Variable(unit = "deg/s", min = 2, max = 60, ifAbsent = 20) @Description("Maximum roll rate.")
          double rollRateLimit,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 1.1)
          @Description("Aileron per roll rate.")
          double rollRateForwardGain,
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 0.2)
          @Description("Aileron per roll-rate error.")
          double rollRateGain,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 0.1)
          @Description("Aileron per integrated roll-rate error.")
          double rollRateIntegralGain,
      @Variable(min = 0, max = 1, ifAbsent = 0.4) @Description("Maximum aileron from the integral.")
          double aileronTrimLimit) {}

  private final Variables parameters;

  RollLaw(Variables parameters) {
    super(
        "ROLL INTEGRAL",
        new Gains(
            parameters.rollRateForwardGain(),
            parameters.rollRateGain(),
            parameters.rollRateIntegralGain(),
            parameters.aileronTrimLimit()));
    this.parameters = parameters;
  }

  /** Aileron, −1…1, positive rolls right. */
  double aileron(FlightState state, double bankRad, double scale, double dtS) {
    double error = Limit.angle(bankRad - state.rollRad());
    double rate =
        Limit.symmetric(
            error / parameters.bankTimeConstant(), Math.toRadians(parameters.rollRateLimit()));
    return step(rate, state.rollRate(), scale, dtS);
  }
}
