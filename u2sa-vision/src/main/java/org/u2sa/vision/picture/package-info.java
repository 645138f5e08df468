/**
 * Pixel-level image processing: brightness and tint, JPEG coding. Geometry is in {@link
 * org.u2sa.vision.ground}.
 */
package org.u2sa.vision.picture;
