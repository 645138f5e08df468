/**
 * Blue Robotics sonars using the ping protocol. Sonars with text output belong to {@code
 * org.u2sa.drivers.range}.
 */
package org.u2sa.drivers.sonar;
