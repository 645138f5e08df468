/**
 * Range finders: single beams as objects, scanning lasers as point clouds, in the vehicle's axes by
 * the sensor's mounting pose. What the objects are is decided by the World Modeler.
 */
package org.u2sa.drivers.range;
