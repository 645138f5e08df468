/**
 * GNSS receiver protocols and setup. Transport belongs to {@code org.u2sa.drivers.link}, the use of
 * fixes to {@code org.u2sa.device}.
 */
package org.u2sa.drivers.gps;
