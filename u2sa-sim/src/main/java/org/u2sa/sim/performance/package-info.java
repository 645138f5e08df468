/**
 * Measures what a simulated vehicle can do: which commands move it along one axis, and how it then
 * moves. Reading vehicles and wording the figures belong to {@code file}.
 */
package org.u2sa.sim.performance;
