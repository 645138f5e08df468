package org.u2sa.core.control.fixedwing;

import org.u2sa.messages.frame.Gravity;
import org.u2sa.service.HandOver;

/**
 * Keeps the turn coordinated by the rudder: damps yaw about r = g/V · sin φ cos θ (coordinated
 * turn; Stevens and Lewis, 2nd ed., section 4.4), meets the adverse yaw of the ailerons, and takes
 * the sideslip out slowly, which trims the propeller's swirl.
 */
final class YawLaw {
  /**
   * @param damping rudder per yaw rate error [s/rad] at the reference speed
   * @param sideslip rudder per sideslip [1/rad]
   * @param sideslipIntegral rudder per integrated sideslip [1/(rad s)]
   * @param integralLimit most of the rudder that the integral may hold, 0…1
   * @param aileronShare rudder per aileron
   */
  record Parameters(
      double damping,
      double sideslip,
      double sideslipIntegral,
      double integralLimit,
      double aileronShare) {}

  private static final double SLOWEST_MPS = 20.0;

  private final Parameters parameters;
  private double integral;

  YawLaw(Parameters parameters) {
    this.parameters = parameters;
  }

  /** Rudder, −1…1, positive yaws right. */
  double rudder(FlightState state, double aileron, double scale, double dtS) {
    double wanted = coordinatedRate(state);
    double damping = parameters.damping() * scale * (wanted - state.yawRate());
    double next = integral + parameters.sideslipIntegral() * state.betaRad() * dtS;
    integral = Limit.symmetric(next, parameters.integralLimit());
    double raw =
        damping
            + parameters.sideslip() * state.betaRad()
            + integral
            + parameters.aileronShare() * aileron;
    return Limit.symmetric(raw, 1.0);
  }

  /** Yaw rate of a turn without sideslip at the present bank [rad/s]. */
  static double coordinatedRate(FlightState state) {
    double speed = Math.max(SLOWEST_MPS, state.trueAirspeedMps());
    return Gravity.STANDARD_MPS2
        / speed
        * StrictMath.sin(state.rollRad())
        * StrictMath.cos(state.pitchRad());
  }

  void handOver(HandOver state) {
    state.number("YAW INTEGRAL", integral);
  }

  void takeOver(HandOver state) {
    state.number("YAW INTEGRAL").ifPresent(this::restart);
  }

  /** Starts with a rudder held. */
  void restart(double rudder) {
    integral = Limit.symmetric(rudder, parameters.integralLimit());
  }
}
