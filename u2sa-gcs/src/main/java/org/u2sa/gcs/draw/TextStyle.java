package org.u2sa.gcs.draw;

import java.awt.Color;

/**
 * How text looks.
 *
 * @param color its colour
 * @param size font size [px]
 * @param bold whether bold
 * @param anchor which part of the text stands at the given x
 */
public record TextStyle(Color color, double size, boolean bold, Anchor anchor) {

  /** Horizontal alignment. */
  public enum Anchor {
    START,
    MIDDLE,
    END
  }

  private static final String
      HELVETICA_FROM_SPACE = // Adobe's Helvetica.afm, characters 32 to 126, thousandths of the
          // size; @ cut from 1015
          "278278355556556889667191333333389584278333278278556556556556556556556556556556278278584584584556"
              + "999667667722722667611778722278500667556833722778667778722667611722667944667667611278278278469556"
              + "333556556500556556278556556222222500222833556556556556333500278556500722500500500334260334584";
  private static final double UNKNOWN_WIDTH = 0.7; // accented letters, symbols: on the wide side
  private static final double BOLD_FACTOR = 1.08;

  public static TextStyle of(Color color, double size) {
    return new TextStyle(color, size, false, Anchor.START);
  }

  public TextStyle inBold() {
    return new TextStyle(color, size, true, anchor);
  }

  public TextStyle anchored(Anchor at) {
    return new TextStyle(color, size, bold, at);
  }

  /**
   * Estimated width of {@code text} [px], by Helvetica's metrics; needs no font, so that layout is
   * the same everywhere.
   */
  public double widthOf(String text) {
    double width = 0.0;
    for (int i = 0; i < text.length(); i++) {
      width += widthOf(text.charAt(i));
    }
    return width * size * (bold ? BOLD_FACTOR : 1.0);
  }

  private static double widthOf(char c) {
    int at = 3 * (c - ' ');
    if (at < 0 || at + 3 > HELVETICA_FROM_SPACE.length()) {
      return UNKNOWN_WIDTH;
    }
    return Integer.parseInt(HELVETICA_FROM_SPACE.substring(at, at + 3)) / 1000.0;
  }
}
