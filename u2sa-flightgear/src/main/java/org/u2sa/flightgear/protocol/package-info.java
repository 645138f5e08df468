/**
 * FlightGear's generic protocol as U2SA speaks it: one description of the fields, the two XML files
 * that FlightGear reads, and lines of numbers both ways, converted to SI units here and nowhere
 * else. Sockets and uses of the values do not belong here.
 */
package org.u2sa.flightgear.protocol;
