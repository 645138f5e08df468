package org.u2sa.planning.seen;

import org.u2sa.messages.frame.Point;

/**
 * Position of a goal object relative to the vehicle.
 *
 * @param ned its centre: north, east, down [m]
 * @param distanceM to its surface [m], on the plane
 * @param radiusM from its centre to its surface, towards the vehicle [m]
 */
public record SeenTarget(Point ned, double distanceM, double radiusM) {}
