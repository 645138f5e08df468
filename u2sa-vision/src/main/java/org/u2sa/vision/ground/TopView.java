package org.u2sa.vision.ground;

import org.u2sa.device.port.CameraFrame.Intrinsics;
import org.u2sa.vision.lens.LensCalibration;
import org.u2sa.vision.picture.Shades;

/**
 * Bird's-eye view of the ground ahead as a grid, in which paint has the same width at any distance.
 * Row 0 is nearest, column 0 leftmost. Reuses its buffers.
 */
public final class TopView {
  public record Area(double nearM, double farM, double sideM, double cellM) {
    /**
     * @throws IllegalArgumentException if it is empty or has more than four million cells
     */
    public Area {
      if (!(farM > nearM && sideM > 0.0 && cellM > 0.0)
          || (farM - nearM) * 2.0 * sideM / (cellM * cellM) > 4e6) {
        throw new IllegalArgumentException(
            String.format(
                "from %s to %s m ahead, %s m to each side, in cells of %s m",
                nearM, farM, sideM, cellM));
      }
    }

    public int rows() {
      return (int) Math.round((farM - nearM) / cellM);
    }

    public int columns() {
      return (int) Math.round(2.0 * sideM / cellM);
    }
  }

  private static final int FRACTION = 256; // subpixels per pixel

  private final Area area;
  private final byte[] white;
  private final byte[] tint;
  private final boolean[] seen;

  public TopView(Area area) {
    this.area = area;
    int cells = area.rows() * area.columns();
    white = new byte[cells];
    tint = new byte[cells];
    seen = new boolean[cells];
  }

  /**
   * Fills the view from an image.
   *
   * @param hidden pixels that occlude the ground, row-major, at half the resolution
   */
  public void look(Shades shades, GroundView view, boolean[] hidden) {
    LensCalibration lens = view.lens();
    Intrinsics pinhole = lens.pinhole();
    double reach = lens.reach();
    double reach2 = reach * reach;
    boolean isPlain = lens.k1() == 0.0 && lens.k2() == 0.0 && lens.k3() == 0.0;
    isPlain &= lens.p1() == 0.0 && lens.p2() == 0.0;
    int columns = area.columns();
    int rows = area.rows();
    for (int row = 0; row < rows; row++) {
      double[] from = view.cameraFrom(forwardM(row), rightM(0));
      double depth = from[0];
      double across = from[1];
      double below = from[2];
      double cell = area.cellM();
      for (int column = 0, at = row * columns; column < columns; column++, at++) {
        seen[at] = false;
        if (depth > 0.05) {
          double x = across / depth;
          double y = below / depth;
          double r2 = x * x + y * y;
          if (r2 <= reach2) {
            if (!isPlain) {
              double radial = 1.0 + r2 * (lens.k1() + r2 * (lens.k2() + r2 * lens.k3()));
              double bent = x * radial + 2.0 * lens.p1() * x * y + lens.p2() * (r2 + 2.0 * x * x);
              y = y * radial + lens.p1() * (r2 + 2.0 * y * y) + 2.0 * lens.p2() * x * y;
              x = bent;
            }
            sample(
                shades,
                pinhole.focalX() * x + pinhole.centreX(),
                pinhole.focalY() * y + pinhole.centreY(),
                hidden,
                at);
          }
        }
        depth += cell * from[3];
        across += cell * from[4];
        below += cell * from[5];
      }
    }
  }

  private void sample(Shades shades, double u, double v, boolean[] hidden, int at) {
    int width = shades.width();
    int column = (int) u;
    int row = (int) v;
    if (u < 0.0 || v < 0.0 || column >= width - 1 || row >= shades.height() - 1) {
      return;
    }
    if (hidden[(row >> 1) * ((width + 1) >> 1) + (column >> 1)]) {
      return;
    }
    int right = (int) ((u - column) * FRACTION);
    int low = (int) ((v - row) * FRACTION);
    int pixel = row * width + column;
    white[at] = blend(shades.white(), pixel, width, right, low);
    tint[at] = blend(shades.tint(), pixel, width, right, low);
    seen[at] = true;
  }

  private static byte blend(byte[] of, int pixel, int width, int right, int low) {
    int left = FRACTION - right;
    int top = (of[pixel] & 0xFF) * left + (of[pixel + 1] & 0xFF) * right;
    int bottom = (of[pixel + width] & 0xFF) * left + (of[pixel + width + 1] & 0xFF) * right;
    return (byte) ((top * (FRACTION - low) + bottom * low + FRACTION * FRACTION / 2) >> 16);
  }

  /** Centre of a row, forward [m]. */
  public double forwardM(double row) {
    return area.nearM() + (row + 0.5) * area.cellM();
  }

  /** Centre of a column, to the right [m]. */
  public double rightM(double column) {
    return -area.sideM() + (column + 0.5) * area.cellM();
  }

  public Area area() {
    return area;
  }

  /** Like {@link Shades#white}, row-major from the nearest row. */
  public byte[] white() {
    return white;
  }

  public byte[] tint() {
    return tint;
  }

  /** Whether a cell is visible: inside the image and not occluded. */
  public boolean[] seen() {
    return seen;
  }
}
