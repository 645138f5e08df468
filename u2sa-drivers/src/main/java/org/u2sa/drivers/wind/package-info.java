/** Anemometers. Pitot airspeed sensors belong to {@code org.u2sa.drivers.sysfs}. */
package org.u2sa.drivers.wind;
