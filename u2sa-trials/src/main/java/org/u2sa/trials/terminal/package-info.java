/** Terminal output of a run: live status and waypoint table. */
package org.u2sa.trials.terminal;
