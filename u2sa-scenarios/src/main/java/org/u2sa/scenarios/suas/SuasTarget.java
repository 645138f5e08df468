package org.u2sa.scenarios.suas;

import java.util.Locale;

/**
 * A plywood target on the ground with a letter on it.
 *
 * @param eastM position on the field's plane [m]
 * @param northM likewise
 * @param sideM size of the shape [m]
 * @param headingRad direction of the letter's top, clockwise from north [rad]
 */
record SuasTarget(
    double eastM,
    double northM,
    double upM,
    double sideM,
    double headingRad,
    String shape,
    String colour,
    String letter,
    String letterColour) {
  private static final String[] POINTS = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};

  /** The same target at a different height. */
  SuasTarget up(double metres) {
    return new SuasTarget(
        eastM, northM, metres, sideM, headingRad, shape, colour, letter, letterColour);
  }

  /** Colour at a position: red, green, blue; null outside the target. */
  int[] paint(double atEastM, double atNorthM) {
    double north = atNorthM - northM;
    double east = atEastM - eastM;
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    double up = (north * cos + east * sin) / sideM;
    double right = (east * cos - north * sin) / sideM;
    if (!TargetLook.isOn(shape, right, up)) {
      return null;
    }
    return TargetLook.rgb(BlockLetters.isInk(letter, right, up) ? letterColour : colour);
  }

  /** Compass point towards the letter's top. */
  String orientation() {
    int octant = (int) Math.round(headingRad / (Math.PI / 4.0));
    return POINTS[Math.floorMod(octant, POINTS.length)];
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s %s with %s %s facing %s at %.1f, %.1f m",
        colour,
        shape,
        letterColour,
        letter,
        orientation(),
        eastM,
        northM);
  }
}
