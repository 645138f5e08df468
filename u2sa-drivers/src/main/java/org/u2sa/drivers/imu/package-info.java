/**
 * Protocols of attitude and heading reference units. Transport belongs to {@code
 * org.u2sa.drivers.link}, the use of readings to {@code org.u2sa.device}.
 */
package org.u2sa.drivers.imu;
