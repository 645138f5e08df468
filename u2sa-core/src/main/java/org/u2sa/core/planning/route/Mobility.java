package org.u2sa.core.planning.route;

import org.u2sa.core.planning.search.BodyDiscs;

/**
 * What a vehicle is and can do, as planners need it. Immutable.
 *
 * @param body what it fills
 * @param clearanceM what is to be kept from obstacles [m]
 * @param turnRadiusM of its tightest turn at its present speed [m]; 0 if it turns on the spot
 * @param reverses whether it can go backwards
 */
public record Mobility(BodyDiscs body, double clearanceM, double turnRadiusM, boolean reverses) {}
