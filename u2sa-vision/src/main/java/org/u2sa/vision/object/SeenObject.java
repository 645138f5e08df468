package org.u2sa.vision.object;

import org.u2sa.messages.frame.Point;

/**
 * Something recognised.
 *
 * @param kind what it is
 * @param foot its middle on the ground, LEVEL
 * @param radiusM of a circle around it on the ground [m]
 * @param heightM above the ground [m]
 * @param alongM standard deviation along the ray from the camera [m]
 * @param acrossM standard deviation across it [m]
 * @param confidence that it is one, 0…1
 * @param left bounds in the picture [pixels]
 * @param top see left
 * @param right see left
 * @param bottom see left
 */
public record SeenObject(
    ObjectKind kind,
    Point foot,
    double radiusM,
    double heightM,
    double alongM,
    double acrossM,
    double confidence,
    int left,
    int top,
    int right,
    int bottom) {}
