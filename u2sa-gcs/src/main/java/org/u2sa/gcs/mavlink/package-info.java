/**
 * The MAVLink bridge: lets QGroundControl, Mission Planner, MAVProxy and MAVSDK operate a vehicle
 * as a client of its broker, with the rights of the bridge's user (docs/mavlink.md).
 */
package org.u2sa.gcs.mavlink;
