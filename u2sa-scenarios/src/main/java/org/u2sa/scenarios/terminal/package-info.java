/** What a run shows on the terminal: its live status and its table of waypoints. */
package org.u2sa.scenarios.terminal;
