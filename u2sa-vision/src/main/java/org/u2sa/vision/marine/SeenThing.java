package org.u2sa.vision.marine;

import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;

/**
 * A detected object.
 *
 * @param way unit vector from the camera in camera axes: ahead, right, down
 * @param rangeM distance from the camera [m]
 * @param rangeSigmaM its standard deviation [m]
 * @param axisEnd direction of one end of a path marker's or bin's long axis, like way
 * @param confidence 0…1
 */
record SeenThing(
    MarineKind kind,
    Optional<Colour> colour,
    Point way,
    double rangeM,
    double rangeSigmaM,
    Optional<Point> axisEnd,
    double confidence) {}
