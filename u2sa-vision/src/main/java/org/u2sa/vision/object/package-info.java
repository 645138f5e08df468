/**
 * Detection of upright objects by colour: barrels, sawhorses, flags. Paint on the ground is in
 * {@link org.u2sa.vision.line}.
 */
package org.u2sa.vision.object;
