/**
 * The commands that fly the Cessna: the demo in the embedded simulator and the flight in
 * FlightGear. Control, link and reports have their own packages.
 */
package org.u2sa.scenarios.cessna;
