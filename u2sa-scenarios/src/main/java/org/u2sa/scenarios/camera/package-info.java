/**
 * Commands for a vehicle's camera: calibration, and display of detections, with images from files
 * or the camera. Detection belongs to {@link org.u2sa.vision.camera}.
 */
package org.u2sa.scenarios.camera;
