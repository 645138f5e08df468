package org.u2sa.planning.route;

import org.u2sa.planning.search.BodyDiscs;

/**
 * Shape and mobility of a vehicle for planners. Immutable.
 *
 * @param body its shape
 * @param clearanceM clearance to keep from obstacles [m]
 * @param turnRadiusM minimum turn radius at its current speed [m]; 0 if it turns in place
 * @param reverses whether it can reverse
 */
public record Mobility(BodyDiscs body, double clearanceM, double turnRadiusM, boolean reverses) {}
