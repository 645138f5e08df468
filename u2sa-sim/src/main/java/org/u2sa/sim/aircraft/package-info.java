/**
 * A six-degree-of-freedom Cessna 172 as pure physics: controls in, state out, the same doubles for
 * the same inputs and seed. Sockets, services, messages and clocks do not belong here.
 */
package org.u2sa.sim.aircraft;
