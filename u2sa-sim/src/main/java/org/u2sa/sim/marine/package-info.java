/**
 * Simulated vessels on and under water with six degrees of freedom, after Fossen: Handbook of
 * Marine Craft Hydrodynamics and Motion Control (2nd ed., 2021). No waves, no sea bed.
 */
package org.u2sa.sim.marine;
