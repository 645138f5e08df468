package org.u2sa.vision.object;

import org.u2sa.messages.frame.Point;

/**
 * A detected object.
 *
 * @param kind kind of object
 * @param foot centre on the ground, LEVEL
 * @param radiusM radius of its bounding circle on the ground [m]
 * @param heightM height above the ground [m]
 * @param alongM standard deviation along the ray from the camera [m]
 * @param acrossM standard deviation across the ray [m]
 * @param confidence detection confidence, 0…1
 * @param left image bounds [px]
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
