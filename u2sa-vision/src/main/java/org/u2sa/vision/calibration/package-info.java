/**
 * Calibrates cameras from chessboard images with BoofCV, whose types are confined to this package.
 * The result is used by {@link org.u2sa.vision.lens}.
 */
package org.u2sa.vision.calibration;
