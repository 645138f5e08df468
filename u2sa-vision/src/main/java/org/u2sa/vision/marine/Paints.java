package org.u2sa.vision.marine;

import java.util.Optional;
import org.u2sa.messages.marine.Colour;

/** Names of linear colours. */
final class Paints {
  private static final double GREY = 0.42; // saturation below which a colour has no name
  private static final double BRIGHT = 1.6; // min. brightness of white over background
  private static final double DARK = 0.45; // maximum brightness of black

  private Paints() {}

  /**
   * Name by hue (Smith, Color gamut transform pairs, SIGGRAPH 1978); empty for a grey that is
   * neither white nor black.
   *
   * @param red linear, in white light; like green and blue
   * @param brightness relative to the background
   */
  static Optional<Colour> name(double red, double green, double blue, double brightness) {
    double most = Math.max(red, Math.max(green, blue));
    double least = Math.min(red, Math.min(green, blue));
    double range = most - least;
    if (most <= 0.0 || range / most < GREY) {
      return brightness > BRIGHT
          ? Optional.of(Colour.WHITE)
          : brightness < DARK ? Optional.of(Colour.BLACK) : Optional.empty();
    }
    double hue =
        most == red
            ? (green - blue) / range
            : most == green ? 2.0 + (blue - red) / range : 4.0 + (red - green) / range;
    return Optional.of(named(60.0 * hue));
  }

  private static Colour named(double hueDeg) {
    if (hueDeg < 9.0) {
      return Colour.RED;
    } else if (hueDeg < 28.0) {
      return Colour.ORANGE;
    } else if (hueDeg < 70.0) {
      return Colour.YELLOW;
    } else if (hueDeg < 180.0) {
      return Colour.GREEN;
    } else if (hueDeg < 257.0) {
      return Colour.BLUE;
    }
    return hueDeg < 325.0 ? Colour.PURPLE : Colour.RED;
  }
}
