/**
 * The Simulator service (thesis 4.5.2.1) and the links to a simulated aircraft: FlightGear's
 * generic protocol over TCP, and the embedded aircraft in lockstep. Control of the aircraft does
 * not belong here.
 */
package org.u2sa.flightgear.link;
