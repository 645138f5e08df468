package org.u2sa.estimation.measurement;

/**
 * Default standard deviations of measurements without one.
 *
 * @param position [m]
 * @param velocity [m/s]
 * @param attitude roll, pitch, heading [rad]
 * @param rate [rad/s]
 * @param force specific force [m/s²]
 * @param fluid speed through the fluid [m/s]
 */
public record UsualSigmas(
    double position, double velocity, double attitude, double rate, double force, double fluid) {}
