/**
 * Comparison of a run with its mission by ground truth: plan, track, surroundings, and the
 * resulting score. Independent of simulators and control.
 */
package org.u2sa.report.score;
