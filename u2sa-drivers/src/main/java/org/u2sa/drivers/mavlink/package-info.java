/**
 * Autopilots that speak MAVLink 2 (ArduPilot, PX4), as sensors and as actuators. The library's
 * messages stay within this package.
 */
package org.u2sa.drivers.mavlink;
