package org.u2sa.core.control.fixedwing;

/**
 * Gains and limits of {@link EnergyLaw}. Energy rates are angles: γ + V̇/g, so that the aircraft's
 * weight does not appear.
 *
 * @param altitudeTimeConstantS altitude error over climb rate [s]
 * @param speedTimeConstantS airspeed error over acceleration [s]
 * @param climbLimitMps most climb demanded [m/s]
 * @param sinkLimitMps most descent demanded [m/s]
 * @param verticalAccelerationMps2 how fast the demanded climb may change [m/s²]
 * @param accelerationLimitMps2 most acceleration along the path demanded [m/s²]
 * @param airspeedFilterS time constant of the airspeed's low pass [s]
 * @param throttleTrim throttle of level cruise, 0…1: where the integral begins
 * @param throttleForward throttle per demanded energy rate [1/rad]
 * @param throttleDamping throttle per energy rate error [1/rad]
 * @param throttleIntegral throttle per integrated energy rate error [1/(rad s)]
 * @param throttleLeast 0…1
 * @param throttleMost 0…1
 * @param throttleRate how fast the lever moves [1/s]
 * @param turnDrag induced drag over weight in level flight: added in turns with n² − 1
 * @param pitchDamping pitch per energy balance error
 * @param pitchIntegral pitch per integrated energy balance error [1/s]
 * @param pitchRate how fast the pitch demand moves [rad/s]
 * @param slowestMps airspeed below which flight path angles mean nothing [m/s]
 */
record EnergyParameters(
    double altitudeTimeConstantS,
    double speedTimeConstantS,
    double climbLimitMps,
    double sinkLimitMps,
    double verticalAccelerationMps2,
    double accelerationLimitMps2,
    double airspeedFilterS,
    double throttleTrim,
    double throttleForward,
    double throttleDamping,
    double throttleIntegral,
    double throttleLeast,
    double throttleMost,
    double throttleRate,
    double turnDrag,
    double pitchDamping,
    double pitchIntegral,
    double pitchRate,
    double slowestMps) {}
