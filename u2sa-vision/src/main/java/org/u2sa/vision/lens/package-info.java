/**
 * Camera intrinsics: calibration, and conversion between pixels and rays. Mounting is in {@link
 * org.u2sa.vision.ground}.
 */
package org.u2sa.vision.lens;
