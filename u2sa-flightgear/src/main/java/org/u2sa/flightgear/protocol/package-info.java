/**
 * FlightGear's generic protocol as used by U2SA: one description of the fields, the two XML files
 * that FlightGear reads, and lines of numbers in both directions. Conversion to SI units happens
 * only here. Sockets and uses of the values do not belong here.
 */
package org.u2sa.flightgear.protocol;
