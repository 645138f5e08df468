/**
 * Paths through cost grids for vehicles with a minimum turn radius. Messages and services do not
 * belong here.
 */
package org.u2sa.planning.hybrid;
