/**
 * A camera's picture as objects: what {@link org.u2sa.vision.line} and {@link
 * org.u2sa.vision.object} find in it, as a service and for commands.
 */
package org.u2sa.vision.camera;
