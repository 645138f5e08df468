/** Clocks of a run: real time or lockstep. No other code reads the system time. */
package org.u2sa.interfaces.time;
