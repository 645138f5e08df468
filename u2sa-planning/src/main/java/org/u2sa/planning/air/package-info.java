/**
 * Paths for aircraft, among few obstacles of known shape: arcs and tangents around them. Grids and
 * messages do not belong here.
 */
package org.u2sa.planning.air;
