package org.u2sa.vision.object;

/**
 * Sizes of the objects detected by colour.
 *
 * @param barrelWidthM diameter of a barrel [m]
 * @param barrelHeightM height of a barrel [m]
 * @param barrelBaseM height of a barrel's lowest orange above the ground [m]
 * @param sawhorseWidthM length of a sawhorse's plank [m]
 * @param sawhorseClearM height of its lower plank's lower edge above the ground [m]
 * @param flagWidthM width of a flag's cloth [m]
 * @param flagTopM height of the cloth's upper edge above the ground [m]
 * @param flagClothM height of the cloth [m]
 * @param farthestM maximum reported distance [m]
 */
public record ObjectSettings(
    double barrelWidthM,
    double barrelHeightM,
    double barrelBaseM,
    double sawhorseWidthM,
    double sawhorseClearM,
    double flagWidthM,
    double flagTopM,
    double flagClothM,
    double farthestM) {}
