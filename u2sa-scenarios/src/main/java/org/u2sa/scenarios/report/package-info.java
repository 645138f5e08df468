/**
 * Results of a run: its track, its score against the mission by ground truth, and the files that
 * contain them. Independent of simulators, control and terminal output.
 */
package org.u2sa.scenarios.report;
