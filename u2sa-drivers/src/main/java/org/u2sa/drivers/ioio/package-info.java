/**
 * The IOIO board (thesis 4.6.2.1): the service that has GPS, compass, motors, radio and battery on
 * its pins, and the connections to it. What the devices at the pins say is understood in their own
 * packages; the firmware simulator is in u2sa-sim.
 */
package org.u2sa.drivers.ioio;
