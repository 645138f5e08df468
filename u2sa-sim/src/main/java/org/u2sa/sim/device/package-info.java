/**
 * Simulated devices without bytes: the ports of {@code org.u2sa.device}, straight from the truth
 * and the error models of {@code org.u2sa.sim.sensor}. What a real device's bytes look like belongs
 * there.
 */
package org.u2sa.sim.device;
