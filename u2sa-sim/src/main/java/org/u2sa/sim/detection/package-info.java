/** Simulated sensors that recognise objects themselves. */
package org.u2sa.sim.detection;
