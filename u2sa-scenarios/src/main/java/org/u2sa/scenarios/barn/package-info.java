/**
 * The worlds of BARN (Benchmark Autonomous Robot Navigation) for the simulated rover: read,
 * converted, driven and scored as in the challenge. How the rover drives is configuration of
 * ordinary services and belongs to config/ugv.
 */
package org.u2sa.scenarios.barn;
