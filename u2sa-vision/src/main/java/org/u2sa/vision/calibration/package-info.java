/**
 * Measures a camera's geometry with pictures of a chessboard, by BoofCV, whose types stay in here.
 * What is done with the result belongs to {@link org.u2sa.vision.lens}.
 */
package org.u2sa.vision.calibration;
