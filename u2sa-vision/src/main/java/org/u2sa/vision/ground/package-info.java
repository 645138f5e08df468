/**
 * Where on the ground a pixel lies, and the ground as seen from above. What is on it belongs to
 * {@link org.u2sa.vision.line} and {@link org.u2sa.vision.object}.
 */
package org.u2sa.vision.ground;
