/**
 * Radio receiver pulses: the automatic/manual switch (thesis 4.6.3). Pulse measurement belongs to
 * the boards.
 */
package org.u2sa.drivers.rc;
