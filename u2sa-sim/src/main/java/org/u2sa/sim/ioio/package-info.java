/**
 * A simulated IOIO board: the firmware's wire protocol and pin behaviour, served over TCP or
 * in-process. Vehicles behind the pins and the host-side IOIO library belong elsewhere; nothing
 * here depends on them.
 */
package org.u2sa.sim.ioio;
