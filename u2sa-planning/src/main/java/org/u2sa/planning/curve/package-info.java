/**
 * Shortest paths of vehicles with a minimum turn radius: arcs and straights. Obstacles and grids do
 * not belong here.
 */
package org.u2sa.planning.curve;
