/**
 * Inertial measurement units that know their attitude: what their bytes mean. How the bytes come
 * belongs to {@code org.u2sa.drivers.link}, what becomes of a reading to {@code org.u2sa.device}.
 */
package org.u2sa.drivers.imu;
