package org.u2sa.vision.line;

import org.u2sa.messages.frame.Point;

/**
 * A white disc on the ground, by which IGVC marks a pothole.
 *
 * @param centre LEVEL
 * @param radiusM that of a disc of the same area [m]
 */
public record PaintedDisc(Point centre, double radiusM) {}
