/**
 * The demo of the ground vehicle (thesis 4.6): a simulated vehicle with a simulated IOIO board,
 * driven by the same services as the real one. Control laws are in core, vehicle and sensors in
 * sim, the board's service in drivers.
 */
package org.u2sa.scenarios.ugv;
