package org.u2sa.vision.line;

/**
 * Criteria for painted lines.
 *
 * @param widthM line width [m]; 0.0762 is 3 in
 * @param contrast minimum contrast to the ground on both sides, as brightness ratio minus 1: 0.15
 *     is 15 %
 * @param noiseFactor minimum contrast in multiples of the ground's roughness
 * @param shortestM minimum length of a line [m]
 * @param longestGapM longest gap of worn or missing paint to bridge [m]
 * @param pieceM maximum length of a piece; longer lines are cut [m]
 */
public record PaintSettings(
    double widthM,
    double contrast,
    double noiseFactor,
    double shortestM,
    double longestGapM,
    double pieceM) {}
