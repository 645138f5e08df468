/**
 * Commands for a vehicle's camera: to calibrate it and to see what it recognises; pictures from
 * files and from the camera itself. What is recognised is {@link org.u2sa.vision.camera}'s matter.
 */
package org.u2sa.scenarios.camera;
