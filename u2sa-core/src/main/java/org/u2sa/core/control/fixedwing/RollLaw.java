package org.u2sa.core.control.fixedwing;

import org.u2sa.service.HandOver;

/** Holds a bank by the ailerons: proportional bank loop around a rate loop. */
final class RollLaw {
  /**
   * @param timeConstantS of the bank error [s]
   * @param rateLimit most roll rate demanded [rad/s]
   * @param rate the inner loop
   */
  record Parameters(double timeConstantS, double rateLimit, RateLoop.Gains rate) {}

  private final Parameters parameters;
  private final RateLoop loop;

  RollLaw(Parameters parameters) {
    this.parameters = parameters;
    this.loop = new RateLoop(parameters.rate());
  }

  /** Aileron, −1…1, positive rolls right. */
  double aileron(FlightState state, double bankRad, double scale, double dtS) {
    double error = Limit.angle(bankRad - state.rollRad());
    double rate = Limit.symmetric(error / parameters.timeConstantS(), parameters.rateLimit());
    return loop.step(rate, state.rollRate(), scale, dtS);
  }

  void restart() {
    loop.restart(0.0);
  }

  /** Starts with a surface held. */
  void restart(double surface) {
    loop.restart(surface);
  }

  void handOver(HandOver state) {
    state.number("ROLL INTEGRAL", loop.integral());
  }

  void takeOver(HandOver state) {
    state.number("ROLL INTEGRAL").ifPresent(loop::restart);
  }
}
