/**
 * A simulated IOIO board: its firmware's wire protocol and what happens at its pins, served over
 * TCP or within the process. Vehicles behind the pins belong in other packages, and so does the
 * library that talks to the board: nothing here depends on it.
 */
package org.u2sa.sim.ioio;
