/**
 * Terrain known to services, from a file. Mapping by sensors belongs to u2sa-world, simulation to
 * u2sa-sim.
 */
package org.u2sa.interfaces.terrain;
