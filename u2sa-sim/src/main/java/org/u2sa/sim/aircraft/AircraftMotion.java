package org.u2sa.sim.aircraft;

/**
 * Ground-truth state of the aircraft.
 *
 * @param timeS simulated time since the start [s]
 * @param longitudeDeg WGS-84, east positive [°, −180…180]
 * @param latitudeDeg WGS-84, geodetic, north positive [°]
 * @param altitudeM centre of gravity above mean sea level [m]
 * @param heightAboveGroundM height above the parked position on its wheels [m], about 0 on the
 *     ground
 * @param rollRad right wing down positive [rad, −π…π]
 * @param pitchRad nose up positive [rad, −π/2…π/2]
 * @param headingRad true heading of the nose [rad, 0…2π)
 * @param rollRateRadPerS p, about the forward axis [rad/s]
 * @param pitchRateRadPerS q, about the right axis [rad/s]
 * @param yawRateRadPerS r, about the down axis [rad/s]
 * @param velocityNorthMps over ground [m/s]
 * @param velocityEastMps over ground [m/s]
 * @param velocityDownMps [m/s]
 * @param trueAirspeedMps [m/s]
 * @param calibratedAirspeedMps reading of an ideal airspeed indicator [m/s]
 * @param angleOfAttackRad [rad]
 * @param sideslipRad positive for airflow from the right [rad]
 * @param engineRpm speed of engine and propeller [1/min]
 * @param weightOnWheels whether a main wheel carries load
 * @param crashed whether the aircraft hit the ground too hard or with anything but its wheels; its
 *     state is then frozen
 * @param stalled whether the wing is past its stall angle in flight
 * @param loadFactor specific force upwards along the body axis [g]: 1 in level flight and at rest
 */
public record AircraftMotion(
    double timeS,
    double longitudeDeg,
    double latitudeDeg,
    double altitudeM,
    double heightAboveGroundM,
    double rollRad,
    double pitchRad,
    double headingRad,
    double rollRateRadPerS,
    double pitchRateRadPerS,
    double yawRateRadPerS,
    double velocityNorthMps,
    double velocityEastMps,
    double velocityDownMps,
    double trueAirspeedMps,
    double calibratedAirspeedMps,
    double angleOfAttackRad,
    double sideslipRad,
    double engineRpm,
    boolean weightOnWheels,
    boolean crashed,
    boolean stalled,
    double loadFactor) {}
