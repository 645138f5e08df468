/**
 * Common to all simulated vehicles: stepping, actuators, ground truth and contacts. The physics of
 * each kind of vehicle has its own package.
 */
package org.u2sa.sim.vehicle;
