package org.u2sa.sim.camera;

/**
 * The painted lawn as cameras look it up: a map with its colours and shadows, and a finer pattern
 * of blades that repeats.
 *
 * @param map red, green, blue from the highest bits but eight down; highest eight: sunlit share
 * @param westM of the middle of the map's first column [m]
 * @param southM of the middle of its first row [m]
 * @param cellM edge of its cells [m]
 * @param blades brightness in the lowest bits, 128 is that of the map
 * @param bladeM edge of the pattern's cells [m]
 */
record Lawn(MipMap map, double westM, double southM, double cellM, MipMap blades, double bladeM) {}
