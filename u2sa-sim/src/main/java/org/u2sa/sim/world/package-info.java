/**
 * What surrounds simulated vehicles: ground, obstacles, wind and water, and what a ray or a
 * footprint meets there. Vehicles and the errors of sensors belong to packages of their own.
 */
package org.u2sa.sim.world;
