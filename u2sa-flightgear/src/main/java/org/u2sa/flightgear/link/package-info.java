/**
 * The Simulator service (thesis 4.5.2.1) and the ways to a simulated aircraft: FlightGear's generic
 * protocol over TCP, and the embedded aircraft in lockstep. How the aircraft is flown does not
 * belong here.
 */
package org.u2sa.flightgear.link;
