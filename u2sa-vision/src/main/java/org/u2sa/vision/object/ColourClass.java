package org.u2sa.vision.object;

/** Colours that identify objects on a course. The ordinal is the class number. */
enum ColourClass {
  /** None of them. */
  OTHER,
  /** Of barrels and sawhorses. */
  ORANGE,
  /** Of flags. */
  RED,
  /** Of flags. */
  BLUE;

  private static final double DARKEST = 35.0; // brightness below which hue is noise

  /**
   * The class of a colour by hue and saturation (Smith, Color gamut transform pairs, SIGGRAPH
   * 1978), which are largely independent of illumination.
   *
   * @param red 0…255, like blue and green
   */
  static ColourClass of(double red, double green, double blue) {
    double most = Math.max(red, Math.max(green, blue));
    double least = Math.min(red, Math.min(green, blue));
    if (most < DARKEST) {
      return OTHER;
    }
    double range = most - least;
    double saturation = range / most;
    if (most == red) {
      double hue = 60.0 * (green - blue) / Math.max(1.0, range); // [deg], -60 magenta to 60 yellow
      if (hue >= 9.0 && hue <= 38.0 && saturation >= 0.55) {
        return ORANGE;
      }
      return hue > -25.0 && hue < 9.0 && saturation >= 0.55 ? RED : OTHER;
    }
    if (most == blue) {
      double hue = 240.0 + 60.0 * (red - green) / Math.max(1.0, range);
      return hue >= 215.0 && hue <= 262.0 && saturation >= 0.5 ? BLUE : OTHER;
    }
    return OTHER;
  }
}
