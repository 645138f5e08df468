package org.u2sa.sim.camera;

/**
 * Texture of the painted lawn: a map of colours and shadows, and a finer repeating pattern of grass
 * blades.
 *
 * @param map ARGB layout with the sunlit share in the top eight bits
 * @param westM centre of the map's first column [m]
 * @param southM centre of its first row [m]
 * @param cellM cell size of the map [m]
 * @param blades brightness; 128 leaves the map unchanged
 * @param bladeM cell size of the pattern [m]
 */
record Lawn(
    MipMap map, double westM, double southM, double cellM, TiledMap blades, double bladeM) {}
