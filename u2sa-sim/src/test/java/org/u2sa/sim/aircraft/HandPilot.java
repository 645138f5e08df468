package org.u2sa.sim.aircraft;

/** A patient pilot for tests: holds pitch, bank and heading by proportion and rate. */
final class HandPilot {
  private HandPilot() {}

  /** Surfaces that hold a pitch and a bank; rudder against the sideslip. */
  static ControlInputs hold(
      AircraftMotion state, ControlInputs base, double pitchRad, double rollRad, double trim) {
    double elevator = trim - 2.0 * (pitchRad - state.pitchRad()) + 0.5 * state.pitchRateRadPerS();
    double aileron = 2.0 * (rollRad - state.rollRad()) - 0.5 * state.rollRateRadPerS();
    double rudder = 1.5 * state.sideslipRad();
    return ControlInputs.limited(
        aileron,
        elevator,
        rudder,
        base.throttle(),
        base.mixture(),
        base.flaps(),
        base.brakeLeft(),
        base.brakeRight());
  }

  /** Surfaces that keep a heading on the ground roll. */
  static ControlInputs steer(
      AircraftMotion state, ControlInputs base, double headingRad, double elevator) {
    double error = StrictMath.IEEEremainder(headingRad - state.headingRad(), 2.0 * Math.PI);
    return ControlInputs.limited(
        -state.rollRad(),
        elevator,
        3.0 * error - state.yawRateRadPerS(),
        base.throttle(),
        base.mixture(),
        base.flaps(),
        base.brakeLeft(),
        base.brakeRight());
  }
}
