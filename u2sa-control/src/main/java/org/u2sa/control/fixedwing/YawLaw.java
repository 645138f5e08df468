package org.u2sa.control.fixedwing;

import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.frame.Gravity;

/**
 * Coordinates turns by rudder: damps yaw about r = g/V · sin φ cos θ (coordinated turn; Stevens and
 * Lewis, 2nd ed., section 4.4), compensates the adverse yaw of the ailerons, and slowly removes
 * sideslip, which trims the propeller's swirl.
 */
final class YawLaw {
  /** Gains at the reference speed. */
  record Variables(
      @Variable(unit = "s/rad", min = 0, max = 5, ifAbsent = 0.5)
          @Description("Rudder per deviation from the yaw rate of a coordinated turn.")
          double yawDamping,
      @Variable(unit = "1/rad", min = 0, max = 5, ifAbsent = 0.8)
          @Description("Rudder per sideslip.")
          double sideslipGain,
      @Variable(unit = "1/rad/s", min = 0, max = 5, ifAbsent = 0.4)
          @Description("Rudder per integrated sideslip.")
          double sideslipIntegralGain,
      @Variable(min = 0, max = 1, ifAbsent = 0.5) @Description("Maximum rudder from the integral.")
          double rudderTrimLimit,
      @Variable(min = 0, max = 1, ifAbsent = 0.45) @Description("Rudder per aileron: adverse yaw.")
          double aileronToRudder) {}

  private static final double SLOWEST_MPS = 5.0;

  private final Variables parameters;
  private double integral;

  YawLaw(Variables parameters) {
    this.parameters = parameters;
  }

  /** Rudder, −1…1, positive yaws right. */
  double rudder(FlightState state, double aileron, double scale, double dtS) {
    double wanted = coordinatedRate(state);
    double damping = parameters.yawDamping() * scale * (wanted - state.yawRate());
    double next = integral + parameters.sideslipIntegralGain() * state.betaRad() * dtS;
    integral = Limit.symmetric(next, parameters.rudderTrimLimit());
    double raw =
        damping
            + parameters.sideslipGain() * state.betaRad()
            + integral
            + parameters.aileronToRudder() * aileron;
    return Limit.symmetric(raw, 1.0);
  }

  /** Yaw rate of a turn without sideslip at the current bank [rad/s]. */
  static double coordinatedRate(FlightState state) {
    double speed = Math.max(SLOWEST_MPS, state.trueAirspeedMps());
    return Gravity.STANDARD_MPS2
        / speed
        * StrictMath.sin(state.rollRad())
        * StrictMath.cos(state.pitchRad());
  }

  void transfer(Transfer state) {
    restart(state.number("YAW INTEGRAL", integral, integral));
  }

  /** Starts bumplessly at a rudder position. */
  void restart(double rudder) {
    boolean isOn = parameters.sideslipIntegralGain() > 0.0;
    integral = isOn ? Limit.symmetric(rudder, parameters.rudderTrimLimit()) : 0.0;
  }
}
