/**
 * What stands on the ground and is known by its colour: barrels, sawhorses, flags. Paint on the
 * ground belongs to {@link org.u2sa.vision.line}.
 */
package org.u2sa.vision.object;
