/**
 * The results of a run: its track, its score against the mission by truth, and the files that tell
 * of both. Independent of simulators and control; terminal output is not here.
 */
package org.u2sa.scenarios.report;
