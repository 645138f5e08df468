/**
 * Ground vehicles as pure physics: commands in, ground truth out, deterministic to the bit. Sensor
 * models belong to {@code org.u2sa.sim.sensor}; sockets, services, messages and clocks do not
 * belong here.
 */
package org.u2sa.sim.ground;
