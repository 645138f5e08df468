/**
 * Ground vehicles as pure physics: commands in, truth out, the same doubles for the same inputs.
 * What their sensors make of it belongs to {@code org.u2sa.sim.sensor}; sockets, services, messages
 * and clocks do not belong here.
 */
package org.u2sa.sim.ground;
