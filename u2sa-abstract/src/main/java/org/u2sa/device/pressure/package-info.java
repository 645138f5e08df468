/** Altitude from air pressure, and the reference pressure. */
package org.u2sa.device.pressure;
