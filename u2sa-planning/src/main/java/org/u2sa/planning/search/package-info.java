/**
 * Paths through grids: distances to obstacles, costs of cells, and searches over them. Plain arrays
 * and metres; messages, services and vehicles' dynamics do not belong here.
 */
package org.u2sa.planning.search;
