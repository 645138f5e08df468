/**
 * Object detection in camera images with {@link org.u2sa.vision.line} and {@link
 * org.u2sa.vision.object}, as a service and for commands.
 */
package org.u2sa.vision.camera;
