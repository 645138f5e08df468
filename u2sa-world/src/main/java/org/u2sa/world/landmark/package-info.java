/** Landmarks: objects of known place that correct the vehicle's state. */
package org.u2sa.world.landmark;
