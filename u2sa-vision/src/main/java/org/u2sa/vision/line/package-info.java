/**
 * Detection of white paint on the ground, lines and discs, in the bird's-eye view. Upright objects
 * are in {@link org.u2sa.vision.object}.
 */
package org.u2sa.vision.line;
