/**
 * Radars that track targets. Receivers of traffic reports (ADS-B, AIS) belong to {@code
 * drivers.traffic}.
 */
package org.u2sa.drivers.radar;
