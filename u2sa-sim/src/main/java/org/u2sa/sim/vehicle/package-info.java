/**
 * What all simulated vehicles have in common: steps, actuators, truth and contacts. The physics of
 * each kind of vehicle belongs to a package of its own.
 */
package org.u2sa.sim.vehicle;
