package org.u2sa.control.fixedwing;

/**
 * State of the aircraft at one time, as used by the control laws. North and east are metres in the
 * plane tangent to the earth at the aircraft's first position.
 *
 * @param timeS time of measurement [s]
 * @param northM position [m]
 * @param eastM position [m]
 * @param altitudeM above mean sea level [m, up]
 * @param heightM height of the aircraft above its position on its wheels [m, up]; about 0 on the
 *     ground
 * @param rollRad right wing down positive [rad]
 * @param pitchRad nose up positive [rad]
 * @param headingRad true, clockwise from north [rad]
 * @param rollRate p, about the body's forward axis [rad/s]
 * @param pitchRate q, about the body's right axis [rad/s]
 * @param yawRate r, about the body's down axis [rad/s]
 * @param northMps velocity over ground [m/s]
 * @param eastMps velocity over ground [m/s]
 * @param climbMps velocity upwards [m/s]
 * @param trueAirspeedMps [m/s, at least 0]
 * @param calibratedAirspeedMps [m/s, at least 0]
 * @param alphaRad angle of attack [rad]
 * @param betaRad sideslip, positive if the air comes from the right [rad]
 * @param onGround whether a main wheel carries load
 * @param engineRpm [1/min]
 * @param engineStarting whether the engine is being primed: throttle stays between 0.1 and 0.5
 * @param wheelsSensed whether onGround is measured, instead of concluded from the height
 * @param overGroundKnown whether the velocity over ground is of this time; otherwise the last one
 */
record FlightState(
    double timeS,
    double northM,
    double eastM,
    double altitudeM,
    double heightM,
    double rollRad,
    double pitchRad,
    double headingRad,
    double rollRate,
    double pitchRate,
    double yawRate,
    double northMps,
    double eastMps,
    double climbMps,
    double trueAirspeedMps,
    double calibratedAirspeedMps,
    double alphaRad,
    double betaRad,
    boolean onGround,
    double engineRpm,
    boolean engineStarting,
    boolean wheelsSensed,
    boolean overGroundKnown) {

  /** The same state with weight on the wheels, which no sensor tells. */
  FlightState onWheels() {
    return new FlightState(
        timeS,
        northM,
        eastM,
        altitudeM,
        heightM,
        rollRad,
        pitchRad,
        headingRad,
        rollRate,
        pitchRate,
        yawRate,
        northMps,
        eastMps,
        climbMps,
        trueAirspeedMps,
        calibratedAirspeedMps,
        alphaRad,
        betaRad,
        true,
        engineRpm,
        engineStarting,
        wheelsSensed,
        overGroundKnown);
  }

  /** Speed over ground [m/s]. */
  double groundSpeedMps() {
    return StrictMath.hypot(northMps, eastMps);
  }

  /** Crosswind component across the nose, from the right positive [m/s]. */
  double crosswindMps() {
    return trueAirspeedMps * StrictMath.sin(betaRad);
  }

  /** True over calibrated airspeed: about 1 at low altitude, growing with height. */
  double trueOverCalibrated() {
    return calibratedAirspeedMps > 5.0 ? trueAirspeedMps / calibratedAirspeedMps : 1.0;
  }
}
