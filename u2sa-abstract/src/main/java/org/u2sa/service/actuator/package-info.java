/** Announcements, command expiry, command validation and emergency stops of actuators. */
package org.u2sa.service.actuator;
