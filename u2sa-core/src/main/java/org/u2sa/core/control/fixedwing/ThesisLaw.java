package org.u2sa.core.control.fixedwing;

/**
 * The proportional controllers of thesis 4.5.2.4 and 4.5.2.5: the direction to go moves the
 * aileron, the altitude differential the elevator. Two damping terms that the thesis does not have
 * keep the bank from swinging and the nose from hunting; with their gains at 0 it is the thesis's
 * own.
 */
final class ThesisLaw {
  /**
   * @param directionGain aileron at a direction of 180°, 0…1 of full
   * @param directionLimitRad direction beyond which the aileron moves no further [rad]
   * @param bankGain aileron against the bank [1/rad]; 0: the thesis's own
   * @param altitudeGain elevator at the full altitude differential
   * @param pitchGain elevator against the pitch [1/rad]; 0: the thesis's own
   * @param levelPitchRad pitch of level flight [rad]
   * @param cruiseThrottle throttle of level flight, 0…1
   */
  record Parameters(
      double directionGain,
      double directionLimitRad,
      double bankGain,
      double altitudeGain,
      double pitchGain,
      double levelPitchRad,
      double cruiseThrottle) {}

  private static final double FULL_DIFFERENTIAL_M = 1_000.0 * 0.3048; // 4.5.2.4: full climb
  private static final double LEAST_DIFFERENTIAL_M = 10.0 * 0.3048; // 4.5.2.4: hold altitude

  private final Parameters parameters;

  ThesisLaw(Parameters parameters) {
    this.parameters = parameters;
  }

  Surfaces surfaces(FlightState state, GuidanceTarget target) {
    double bearing = StrictMath.atan2(target.eastM(), target.northM());
    double direction = Limit.angle(bearing - state.headingRad());
    double climb = differential(target.altitudeM() - state.altitudeM());
    double limited = Limit.symmetric(direction, parameters.directionLimitRad());
    double aileron =
        parameters.directionGain() * limited / Math.PI - parameters.bankGain() * state.rollRad();
    double elevator =
        -parameters.altitudeGain() * climb
            + parameters.pitchGain() * (state.pitchRad() - parameters.levelPitchRad());
    double cruise = parameters.cruiseThrottle();
    double throttle = cruise + climb * (climb > 0.0 ? 1.0 - cruise : cruise);
    double rudder = state.onGround() ? limited / parameters.directionLimitRad() : 0.0;
    return new Surfaces(
        Limit.symmetric(aileron, 1.0),
        Limit.symmetric(elevator, 1.0),
        rudder,
        Limit.within(0.0, throttle, 1.0),
        1.0,
        0.0,
        0.0);
  }

  /** Scaled to −1…1: nothing below 10 ft, all from 1000 ft on (4.5.2.4). */
  static double differential(double metres) {
    double beyond = Math.abs(metres) - LEAST_DIFFERENTIAL_M;
    double share = beyond / (FULL_DIFFERENTIAL_M - LEAST_DIFFERENTIAL_M);
    return Math.copySign(Limit.within(0.0, share, 1.0), metres);
  }
}
