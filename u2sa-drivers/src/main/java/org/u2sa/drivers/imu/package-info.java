/**
 * Inertial measurement units that know their attitude: what their bytes mean, and the service that
 * publishes attitude and rates. How the bytes come belongs to {@code org.u2sa.drivers.link}.
 */
package org.u2sa.drivers.imu;
