/**
 * The clock of a run: real or in lockstep. Nothing else in the house asks the system for the time.
 */
package org.u2sa.interfaces.time;
