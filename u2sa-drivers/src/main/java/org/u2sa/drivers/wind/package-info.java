/** Anemometers. Airspeed by pressure belongs to {@code org.u2sa.drivers.sysfs}. */
package org.u2sa.drivers.wind;
