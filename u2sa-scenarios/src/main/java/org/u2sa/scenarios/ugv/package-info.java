/**
 * The demo of the ground vehicle (thesis 4.6): a simulated vehicle behind a simulated IOIO board,
 * driven by the services that drive the real one. The control laws are in core, the vehicle and its
 * sensors in sim, the board's service in drivers.
 */
package org.u2sa.scenarios.ugv;
