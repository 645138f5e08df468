/**
 * MAVLink autopilots (ArduPilot, PX4) as sensors and actuators, and MAVLink sensors. The library's
 * classes do not leave this package.
 */
package org.u2sa.drivers.mavlink;
