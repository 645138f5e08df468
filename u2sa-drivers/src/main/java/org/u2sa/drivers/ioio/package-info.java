/**
 * The IOIO board (thesis 4.6.2.1): its service for GPS, compass, motors, radio and battery, and its
 * connections. Device protocols are in their own packages; the firmware simulator is in u2sa-sim.
 */
package org.u2sa.drivers.ioio;
