/** NMEA 0183 framing and checksums. Interpretation belongs to the device packages. */
package org.u2sa.drivers.nmea;
