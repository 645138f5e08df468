package org.u2sa.vision.object;

/**
 * How large things are that are recognised by colour.
 *
 * @param barrelWidthM diameter of a barrel [m]
 * @param barrelHeightM its height [m]
 * @param barrelBaseM height of the lowest orange above the ground [m]
 * @param sawhorseWidthM length of a sawhorse's plank [m]
 * @param sawhorseClearM height of its lower plank's lower edge above the ground [m]
 * @param flagWidthM of a flag's cloth [m]
 * @param flagTopM height of its upper edge above the ground [m]
 * @param flagClothM height of the cloth [m]
 * @param farthestM beyond which nothing is reported [m]
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
