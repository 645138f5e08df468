/** Altitude by air pressure, and what the pressure is compared with. */
package org.u2sa.device.pressure;
