/**
 * Simulated payloads and their sensors, for the ports of {@code org.u2sa.device.payload} and for
 * servos. Their loads on the vehicle are not simulated.
 */
package org.u2sa.sim.payload;
