package org.u2sa.planning.seen;

import org.u2sa.messages.frame.Point;

/**
 * Position of a goal object relative to the vehicle.
 *
 * @param ned vector to its centre: north, east, down [m]
 * @param distanceM horizontal distance to its surface [m]
 * @param radiusM distance from its centre to its surface, toward the vehicle [m]
 */
public record SeenTarget(Point ned, double distanceM, double radiusM) {}
