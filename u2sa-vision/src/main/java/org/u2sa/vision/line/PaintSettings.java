package org.u2sa.vision.line;

/**
 * What counts as a painted line.
 *
 * @param widthM of the paint [m]; 0.0762 is 3 in
 * @param contrast least ratio of its brightness to the ground's on both sides, over 1: 0.15 is 15 %
 * @param noiseFactor by how many times the ground's own roughness it must be brighter
 * @param shortestM of a line [m]
 * @param longestGapM of worn or missing paint that a line bridges [m]
 * @param pieceM longest line in one piece: a longer one is cut [m]
 */
public record PaintSettings(
    double widthM,
    double contrast,
    double noiseFactor,
    double shortestM,
    double longestGapM,
    double pieceM) {}
