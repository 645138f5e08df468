package org.u2sa.report.mosaic;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/** The picture: each pixel from the image that shows its ground at the finest resolution. */
final class MosaicCanvas {
  private static final int MAX_SAMPLES = 4; // maximum samples of an image, per pixel and side
  private static final int OPAQUE = 0xFF000000;

  private final MosaicGrid grid;
  private final BufferedImage picture;
  private final int[] colours; // of the picture
  private final float[] resolutions; // [m per pixel]; infinite: unseen
  private final double[] spot = new double[3];
  private final double[] sum = new double[3];

  MosaicCanvas(MosaicGrid grid) {
    this.grid = grid;
    picture = new BufferedImage(grid.columns(), grid.rows(), BufferedImage.TYPE_INT_ARGB);
    colours = ((DataBufferInt) picture.getRaster().getDataBuffer()).getData();
    resolutions = new float[grid.columns() * grid.rows()];
    Arrays.fill(resolutions, Float.POSITIVE_INFINITY);
  }

  /** Transparent where nothing was seen. */
  BufferedImage picture() {
    return picture;
  }

  /**
   * Draws an image.
   *
   * @param rgb its pixels by rows
   * @param xs eastings of its corners [m]
   * @param ys northings [m]
   */
  void draw(
      int[] rgb, int width, int height, ImageProjection projection, double[] xs, double[] ys) {
    int left = column(Arrays.stream(xs).min().orElseThrow());
    int right = column(Arrays.stream(xs).max().orElseThrow());
    int top = row(Arrays.stream(ys).max().orElseThrow());
    int bottom = row(Arrays.stream(ys).min().orElseThrow());
    for (int row = top; row <= bottom; row++) {
      for (int column = left; column <= right; column++) {
        double east = grid.eastM(column);
        double north = grid.northM(row);
        int at = row * grid.columns() + column;
        if (projection.project(east, north, spot)
            && spot[0] >= 0.0
            && spot[1] >= 0.0
            && spot[0] <= width - 1.0
            && spot[1] <= height - 1.0
            && spot[2] < resolutions[at]) {
          resolutions[at] = (float) spot[2];
          colours[at] = mean(rgb, width, height, spot, projection, east, north);
        }
      }
    }
  }

  private int column(double eastM) {
    double column = Math.floor((eastM - grid.westM()) / grid.pixelM());
    return (int) Math.max(0.0, Math.min(grid.columns() - 1.0, column));
  }

  private int row(double northM) {
    double row = Math.floor((grid.northM() - northM) / grid.pixelM());
    return (int) Math.max(0.0, Math.min(grid.rows() - 1.0, row));
  }

  /** Mean colour of a pixel's ground, from several samples if the image is finer. */
  private int mean(
      int[] rgb,
      int width,
      int height,
      double[] middle,
      ImageProjection projection,
      double east,
      double north) {
    double pixelM = grid.pixelM();
    int samples = (int) Math.max(1.0, Math.min(MAX_SAMPLES, Math.ceil(pixelM / middle[2])));
    Arrays.fill(sum, 0.0);
    for (int k = 0; k < samples * samples; k++) {
      double aside = ((k % samples + 0.5) / samples - 0.5) * pixelM;
      double up = ((k / samples + 0.5) / samples - 0.5) * pixelM;
      projection.project(east + aside, north + up, spot);
      add(rgb, width, height, spot[0], spot[1]);
    }
    int count = samples * samples;
    int red = (int) Math.round(sum[0] / count);
    int green = (int) Math.round(sum[1] / count);
    int blue = (int) Math.round(sum[2] / count);
    return OPAQUE | red << 16 | green << 8 | blue;
  }

  /** Adds a bilinear sample. */
  private void add(int[] rgb, int width, int height, double column, double row) {
    double x = Math.max(0.0, Math.min(width - 1.0, column));
    double y = Math.max(0.0, Math.min(height - 1.0, row));
    int left = Math.min(Math.max(0, width - 2), (int) x);
    int top = Math.min(Math.max(0, height - 2), (int) y);
    for (int k = 0; k < 4; k++) {
      int c = Math.min(width - 1, left + k % 2);
      int r = Math.min(height - 1, top + k / 2);
      double weight = (1.0 - Math.abs(x - left - k % 2)) * (1.0 - Math.abs(y - top - k / 2));
      int colour = rgb[r * width + c];
      sum[0] += weight * (colour >> 16 & 0xff);
      sum[1] += weight * (colour >> 8 & 0xff);
      sum[2] += weight * (colour & 0xff);
    }
  }

  /** Number of pixels seen. */
  long seen() {
    long count = 0;
    for (float each : resolutions) {
      count += Float.isInfinite(each) ? 0 : 1;
    }
    return count;
  }
}
