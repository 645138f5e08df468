/**
 * Encounters with other vessels: published cases, scaled to a small boat, run in simulation and
 * judged by ground truth. Right of way itself belongs to the planner.
 */
package org.u2sa.scenarios.encounters;
