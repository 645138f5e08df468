/** Receivers of traffic reports, including radars and autopilots' receivers. */
package org.u2sa.drivers.traffic;
