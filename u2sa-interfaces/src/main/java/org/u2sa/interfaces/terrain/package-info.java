/**
 * The shape of the ground that services know, from a file. What sensors see of it belongs to
 * u2sa-world, what simulators make of it to u2sa-sim.
 */
package org.u2sa.interfaces.terrain;
