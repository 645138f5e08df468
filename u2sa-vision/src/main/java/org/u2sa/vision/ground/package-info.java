/**
 * Projection of pixels to the ground, and the bird's-eye view. Detection is in {@link
 * org.u2sa.vision.line} and {@link org.u2sa.vision.object}.
 */
package org.u2sa.vision.ground;
