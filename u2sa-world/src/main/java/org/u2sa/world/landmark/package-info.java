/** Landmarks: objects at known positions that correct the vehicle's state. */
package org.u2sa.world.landmark;
