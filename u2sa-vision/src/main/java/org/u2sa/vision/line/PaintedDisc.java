package org.u2sa.vision.line;

import org.u2sa.messages.frame.Point;

/**
 * A white disc on the ground, IGVC's pothole marking.
 *
 * @param centre LEVEL
 * @param radiusM radius of a disc of equal area [m]
 */
public record PaintedDisc(Point centre, double radiusM) {}
