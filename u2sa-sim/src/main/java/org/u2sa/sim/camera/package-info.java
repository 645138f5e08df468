/**
 * What a colour camera sees of a world: grass, paint, solids and light, rendered in software. The
 * device itself is in {@code device}; which things stand where belongs to the world.
 */
package org.u2sa.sim.camera;
