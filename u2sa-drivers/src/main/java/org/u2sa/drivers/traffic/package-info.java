/** Receivers of other traffic's reports. Radars and receivers of an autopilot belong here, too. */
package org.u2sa.drivers.traffic;
