/**
 * Simulated devices above the byte level: implementations of the ports of {@code org.u2sa.device}
 * fed by the truth and the error models of {@code org.u2sa.sim.sensor}, where byte-level device
 * protocols belong.
 */
package org.u2sa.sim.device;
