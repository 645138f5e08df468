package org.u2sa.scenarios.report;

import java.util.OptionalDouble;

/**
 * Where a flight starts, e.g. the threshold of a runway.
 *
 * @param longitudeDeg longitude, WGS-84 [deg]
 * @param latitudeDeg latitude, WGS-84 [deg]
 * @param altitudeM altitude of the ground there above mean sea level [m]
 * @param headingRad true heading of the take-off [rad], clockwise from north
 * @param runwayLengthM length of runway ahead [m]; empty: unknown
 */
public record StartPlace(
    double longitudeDeg,
    double latitudeDeg,
    double altitudeM,
    double headingRad,
    OptionalDouble runwayLengthM) {}
