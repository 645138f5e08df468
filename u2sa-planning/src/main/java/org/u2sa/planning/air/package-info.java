/**
 * Paths in the air, where obstacles are few and of known shape: arcs and tangents around them.
 * Grids and messages do not belong here.
 */
package org.u2sa.planning.air;
