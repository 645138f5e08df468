/**
 * Payloads and their sensors: gimbals, switched payloads such as grippers and lights, load cells
 * and hydrophone arrays, each with its port and its service. Drivers are in {@code
 * org.u2sa.drivers}, simulated devices in {@code org.u2sa.sim.device}.
 */
package org.u2sa.device.payload;
