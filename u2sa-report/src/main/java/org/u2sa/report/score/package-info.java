/**
 * A run against its mission, by truth: plan, track, surroundings, and the score that comes of them.
 * Independent of simulators and control.
 */
package org.u2sa.report.score;
