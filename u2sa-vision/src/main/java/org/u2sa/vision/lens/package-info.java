/**
 * A camera's own geometry: what a calibration measured, and the way between a pixel and a ray. How
 * the camera is mounted belongs to {@link org.u2sa.vision.ground}.
 */
package org.u2sa.vision.lens;
