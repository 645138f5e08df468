/**
 * Pulses of a radio receiver: the switch between automatic and manual (thesis 4.6.3). How the
 * pulses are measured belongs to the boards.
 */
package org.u2sa.drivers.rc;
