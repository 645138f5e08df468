/**
 * The environment of simulated vehicles: ground, obstacles, wind and water, with ray casting and
 * contact tests. Vehicles and sensor errors have their own packages.
 */
package org.u2sa.sim.world;
