package org.u2sa.sim.sensor;

/**
 * Where a vehicle is and how it moves, for its sensors to be wrong about.
 *
 * @param eastM on the local plane [m]
 * @param northM on the local plane [m]
 * @param upM above it [m]
 * @param eastMps [m/s]
 * @param northMps [m/s]
 * @param upMps [m/s]
 * @param headingRad clockwise from true north [rad]
 */
public record TrueMotion(
    double eastM,
    double northM,
    double upM,
    double eastMps,
    double northMps,
    double upMps,
    double headingRad) {}
