/**
 * Sonars of Blue Robotics' ping family, by one protocol. Sonars that print lines of text belong to
 * {@code org.u2sa.drivers.range}.
 */
package org.u2sa.drivers.sonar;
