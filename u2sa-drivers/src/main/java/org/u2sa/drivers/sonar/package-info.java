/**
 * Sonars, in water and in air: Blue Robotics with the ping protocol, echo sounders with NMEA 0183,
 * MaxBotix with text output.
 */
package org.u2sa.drivers.sonar;
