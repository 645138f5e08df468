package org.u2sa.core.control.fixedwing;

/**
 * Every gain and limit of {@link Autopilot}.
 *
 * @param referenceSpeedMps calibrated airspeed at which the surface gains hold [m/s]
 * @param cruiseMps calibrated airspeed of the cruise [m/s]
 * @param fastestMps most calibrated airspeed demanded [m/s]
 * @param bankLimitRad most bank demanded [rad]
 * @param rollRateLimit how fast the bank demand moves [rad/s]
 * @param turnPitch pitch added per excess load factor [rad]
 * @param leastPitchRad demanded in the cruise
 * @param mostPitchRad demanded ever
 * @param maxCrosswindMps most wind across the approach in which it lands [m/s]
 * @param gustShare of the wind's speed that is added to speeds near the stall
 */
record Tuning(
    double referenceSpeedMps,
    double cruiseMps,
    double fastestMps,
    double bankLimitRad,
    double bankRate,
    double turnPitch,
    double leastPitchRad,
    double mostPitchRad,
    double shortestL1M,
    RollLaw.Parameters roll,
    PitchLaw.Parameters pitch,
    YawLaw.Parameters yaw,
    StallGuard.Parameters stall,
    EnergyParameters energy,
    TakeOffSequence.Parameters takeOff,
    GroundSteering.Parameters ground,
    ClimbOut climbOut,
    Hold hold,
    FlareLaw.Parameters flare,
    TouchDown.Parameters touchDown,
    double maxCrosswindMps,
    double gustShare) {

  /**
   * What the aircraft does without navigation.
   *
   * @param levelS how long the wings stay level [s]
   * @param bankRad then, right wing down positive [rad]
   */
  record Hold(double levelS, double bankRad) {}

  /**
   * How the aircraft leaves the ground.
   *
   * @param startThrottle while the engine starts, 0…1
   * @param throttleRate how fast the throttle opens [1/s]
   * @param rotatePitchRad to which the nose is raised [rad]
   * @param rotateRate how fast [rad/s]
   * @param speedMps calibrated airspeed of the climb-out [m/s]
   * @param leastPitchRad demanded in the climb-out [rad]
   * @param bankLimitRad most bank demanded in the climb-out [rad]
   * @param lookAheadM to the point steered for on the extended centreline [m]
   */
  record ClimbOut(
      double startThrottle,
      double throttleRate,
      double rotatePitchRad,
      double rotateRate,
      double speedMps,
      double leastPitchRad,
      double bankLimitRad,
      double lookAheadM) {}
}
