package org.u2sa.vision.picture;

import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;

/**
 * Luminance and chrominance of an image in blocks, offset by -128 to be centred on 0 (JFIF 1.02,
 * page 3). Beyond the right and lower edges the last column and row are repeated.
 */
final class PicturePlanes {
  private static final double MIDDLE = 128.0;
  private static final double QUARTER = 0.25;

  private final CameraFrame frame;
  private final byte[] pixels;
  private final int bytesPerPixel;

  PicturePlanes(CameraFrame frame) {
    this.frame = frame;
    pixels = frame.pixels();
    bytesPerPixel = frame.format().bytesPerPixel();
  }

  /** Luminance of the block with this upper left pixel. */
  void brightness(int row, int column, double[] samples) {
    boolean grey = frame.format() == PixelFormat.GREY8;
    for (int i = 0; i < samples.length; i++) {
      int at = at(row + i / CosineTransform.SIDE, column + i % CosineTransform.SIDE);
      samples[i] =
          grey
              ? level(at) - MIDDLE
              : 0.299 * level(at) + 0.587 * level(at + 1) + 0.114 * level(at + 2) - MIDDLE;
    }
  }

  /**
   * Colour difference of a block of twice the size; each sample is the mean of 2 x 2 pixels.
   *
   * @param colour 0 for blue, 1 for red
   */
  void colour(int colour, int row, int column, double[] samples) {
    for (int i = 0; i < samples.length; i++) {
      int y = row + 2 * (i / CosineTransform.SIDE);
      int x = column + 2 * (i % CosineTransform.SIDE);
      double sum =
          difference(colour, at(y, x))
              + difference(colour, at(y, x + 1))
              + difference(colour, at(y + 1, x))
              + difference(colour, at(y + 1, x + 1));
      samples[i] = QUARTER * sum;
    }
  }

  private double difference(int colour, int at) {
    return colour == 0
        ? -0.168736 * level(at) - 0.331264 * level(at + 1) + 0.5 * level(at + 2)
        : 0.5 * level(at) - 0.418688 * level(at + 1) - 0.081312 * level(at + 2);
  }

  private int level(int at) {
    return pixels[at] & 0xFF;
  }

  private int at(int row, int column) {
    int y = Math.min(row, frame.height() - 1);
    int x = Math.min(column, frame.width() - 1);
    return bytesPerPixel * (y * frame.width() + x);
  }
}
