/**
 * NMEA 0183 sentences in a stream of bytes: where they begin and end, and whether they came whole.
 * What they mean belongs to the packages of the devices.
 */
package org.u2sa.drivers.nmea;
