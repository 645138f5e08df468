/** Occupancy grid: what scanners measured, as log odds per cell. */
package org.u2sa.world.grid;
