package org.u2sa.vision.marine;

import java.util.Arrays;
import org.u2sa.device.port.CameraFrame;

/**
 * Linear colour of each 2 × 2 pixels of a picture, and of the background of each row: the row's
 * median, i.e. water or sky if objects cover less than half of it. Reuses its buffers.
 */
final class LinearPicture {
  private static final int HUES = 3;
  private static final double GAMMA = 2.2;
  private static final float FAINT = 1.0e-3f;
  private static final float[] LINEAR = new float[256];

  static {
    for (int i = 0; i < LINEAR.length; i++) {
      LINEAR[i] = (float) Math.pow(i / 255.0, GAMMA);
    }
  }

  int width;
  int height;
  float[] cells = new float[0]; // red, green, blue
  float[] median = new float[0]; // of each row: red, green, blue
  float[] spread = new float[0]; // median absolute deviation of each row, relative to its median
  private float[] sorted = new float[0];

  void read(CameraFrame frame) {
    width = frame.width() / 2;
    height = frame.height() / 2;
    if (cells.length != HUES * width * height) {
      cells = new float[HUES * width * height];
      median = new float[HUES * height];
      spread = new float[HUES * height];
      sorted = new float[width];
    }
    byte[] rgb = frame.pixels();
    int stride = HUES * frame.width();
    for (int row = 0; row < height; row++) {
      int at = 2 * row * stride;
      for (int i = HUES * row * width; i < HUES * (row + 1) * width; i += HUES, at += 2 * HUES) {
        for (int hue = 0; hue < HUES; hue++) {
          int k = at + hue;
          cells[i + hue] =
              0.25f
                  * (LINEAR[rgb[k] & 0xFF]
                      + LINEAR[rgb[k + HUES] & 0xFF]
                      + LINEAR[rgb[k + stride] & 0xFF]
                      + LINEAR[rgb[k + stride + HUES] & 0xFF]);
        }
      }
      for (int hue = 0; hue < HUES; hue++) {
        background(row, hue);
      }
    }
  }

  private void background(int row, int hue) {
    for (int column = 0; column < width; column++) {
      sorted[column] = cells[HUES * (row * width + column) + hue];
    }
    Arrays.sort(sorted);
    float middle = Math.max(FAINT, sorted[width / 2]);
    median[HUES * row + hue] = middle;
    for (int column = 0; column < width; column++) {
      sorted[column] = Math.abs(sorted[column] - middle);
    }
    Arrays.sort(sorted);
    spread[HUES * row + hue] = sorted[width / 2] / middle;
  }
}
