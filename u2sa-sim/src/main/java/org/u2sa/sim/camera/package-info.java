/**
 * Software rendering of a world for colour cameras: grass, paint, solids and light. The device
 * itself is in {@code device}; object placement belongs to the world.
 */
package org.u2sa.sim.camera;
