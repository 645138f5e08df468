package org.u2sa.scenarios.report;

import java.util.OptionalDouble;

/**
 * What is measured of aircraft only. An empty number means that the flight never was in the state
 * it is measured in.
 *
 * @param altitudeRmsM RMS over time of the altitude error on level legs [m]: those between
 *     waypoints of one altitude
 * @param altitudeMaxErrorM largest absolute altitude error on level legs [m]
 * @param maxBankRad largest absolute bank in the air [rad]
 * @param minAirspeedMps least calibrated airspeed in the air [m/s]
 * @param tookOff whether the vehicle left the ground and rose {@link RunScorer#SCREEN_HEIGHT_M}
 *     above its start
 */
public record FlightFigures(
    OptionalDouble altitudeRmsM,
    OptionalDouble altitudeMaxErrorM,
    OptionalDouble maxBankRad,
    OptionalDouble minAirspeedMps,
    boolean tookOff) {}
