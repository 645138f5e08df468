package org.u2sa.sim.camera;

/** Linear surface reflectances as 0xRRGGBB. */
final class Reflectance {
  static final int GRASS = rgb(0.085, 0.135, 0.035);
  static final int DRY_GRASS = rgb(0.20, 0.18, 0.08);
  static final int PAINT = rgb(0.78, 0.79, 0.76);
  static final int ORANGE = rgb(0.85, 0.19, 0.02);
  static final int WHITE = rgb(0.80, 0.80, 0.80);
  static final int RUBBER = rgb(0.03, 0.03, 0.03);
  static final int WOOD = rgb(0.42, 0.30, 0.17);
  static final int BOARDS = rgb(0.32, 0.215, 0.10);
  static final int RED = rgb(0.65, 0.03, 0.03);
  static final int BLUE = rgb(0.03, 0.08, 0.50);
  static final int STEEL = rgb(0.25, 0.25, 0.26);
  static final int GREY = rgb(0.35, 0.34, 0.33);

  private static final double FULL = 255.0;

  private Reflectance() {}

  static int of(org.u2sa.messages.marine.Colour paint) {
    return switch (paint) {
      case RED -> rgb(0.55, 0.03, 0.03);
      case ORANGE -> rgb(0.80, 0.20, 0.02);
      case YELLOW -> rgb(0.75, 0.55, 0.03);
      case GREEN -> rgb(0.03, 0.30, 0.06);
      case BLUE -> rgb(0.03, 0.07, 0.42);
      case WHITE -> WHITE;
      case BLACK -> RUBBER;
      case PURPLE -> rgb(0.22, 0.04, 0.30);
    };
  }

  static int rgb(double red, double green, double blue) {
    return byteOf(red) << 16 | byteOf(green) << 8 | byteOf(blue);
  }

  /** Interpolates between two colours: 0 gives the first, 1 the second. */
  static int mix(int first, int other, double share) {
    return part(first, other, share, 16)
        | part(first, other, share, 8)
        | part(first, other, share, 0);
  }

  private static int part(int first, int other, double share, int shift) {
    int a = first >> shift & 0xFF;
    int b = other >> shift & 0xFF;
    return (int) Math.round(a + Math.max(0.0, Math.min(1.0, share)) * (b - a)) << shift;
  }

  private static int byteOf(double value) {
    return (int) Math.round(FULL * Math.max(0.0, Math.min(1.0, value)));
  }
}
