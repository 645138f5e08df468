/**
 * White paint on the ground: lines and discs, found in the view from above. What stands on the
 * ground belongs to {@link org.u2sa.vision.object}.
 */
package org.u2sa.vision.line;
