/**
 * MAVLink autopilots (ArduPilot, PX4) as sensors and actuators, and MAVLink sensors. Frames and
 * messages are those of {@code org.u2sa.mavlink}.
 */
package org.u2sa.drivers.mavlink;
