package org.u2sa.vision.survey;

/**
 * A patch of an image that stands out from the ground, its holes filled.
 *
 * @param left column of its box
 * @param top row of its box
 * @param width width of the box [px]
 * @param height height of the box [px]
 * @param isOn pixels of the patch, row by row in the box
 * @param pixels number of pixels of the patch
 * @param column column of its middle
 * @param row row of its middle
 */
record TargetPatch(
    int left,
    int top,
    int width,
    int height,
    boolean[] isOn,
    int pixels,
    double column,
    double row) {}
