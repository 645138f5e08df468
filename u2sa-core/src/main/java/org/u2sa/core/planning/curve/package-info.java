/**
 * Shortest ways of vehicles that cannot turn tighter than a radius: arcs and straights. Obstacles
 * and grids do not belong here.
 */
package org.u2sa.core.planning.curve;
