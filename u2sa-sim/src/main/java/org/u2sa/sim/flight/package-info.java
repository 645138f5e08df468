/**
 * Simulated small aircraft: a rigid body that rotors or wings carry, described by parameters. Flies
 * over a flat earth; the Cessna 172, which flies far, is in {@link org.u2sa.sim.aircraft}.
 */
package org.u2sa.sim.flight;
