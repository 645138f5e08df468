/**
 * What a vehicle's devices are to the services that use them: one small port and one reading for
 * each kind, and the services that need no more than the port. What the bytes of a real device mean
 * belongs to {@code org.u2sa.drivers}, what a simulated one measures to {@code org.u2sa.sim}.
 */
package org.u2sa.device;
