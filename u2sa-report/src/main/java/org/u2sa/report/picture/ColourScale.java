package org.u2sa.report.picture;

import java.awt.Color;
import java.awt.Paint;
import org.jfree.chart.renderer.PaintScale;

/**
 * Colours for a quantity, in {@link #STEPS} steps of the lower five sixths of matplotlib's viridis
 * (CC0): perceptually uniform, distinguishable with colour vision deficiency, and dark enough on
 * white.
 *
 * @param low lower end of the first step
 * @param high upper end of the last step, more than {@code low}
 */
record ColourScale(double low, double high) implements PaintScale {

  static final int STEPS = 24;

  private static final int[] VIRIDIS = {
    0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xa5db36
  };

  @Override
  public double getLowerBound() {
    return low;
  }

  @Override
  public double getUpperBound() {
    return high;
  }

  @Override
  public Paint getPaint(double value) {
    return colour(step(value, low, high));
  }

  /**
   * Step (0…STEPS−1) of {@code value} on a scale from {@code from} to {@code to}; values outside
   * are clamped.
   */
  static int step(double value, double from, double to) {
    if (!(to > from)) {
      return 0;
    }
    return (int) Math.max(0, Math.min(STEPS - 1, Math.floor(STEPS * (value - from) / (to - from))));
  }

  static Color colour(int step) {
    double at = (double) step / (STEPS - 1) * (VIRIDIS.length - 1);
    int below = Math.min(VIRIDIS.length - 2, (int) at);
    double share = at - below;
    Color a = new Color(VIRIDIS[below]);
    Color b = new Color(VIRIDIS[below + 1]);
    return new Color(
        mix(a.getRed(), b.getRed(), share),
        mix(a.getGreen(), b.getGreen(), share),
        mix(a.getBlue(), b.getBlue(), share));
  }

  private static int mix(int a, int b, double share) {
    return (int) Math.round(a + share * (b - a));
  }
}
