package org.u2sa.vision.survey;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.device.port.CameraFrame;

/**
 * Finds patches whose colour stands out from the mean of the image: of a target's size and entirely
 * within the image. Pixels are joined by flood fill.
 */
final class TargetFinder {
  private static final int STANDS_OUT = 62; // sum of the differences of red, green and blue
  private static final int COARSE = 3; // pixels between two samples
  private static final int MAX_PATCHES = 20; // per image

  private final int width;
  private final int height;
  private final byte[] rgb;
  private final int[] mean = new int[3];
  private final boolean[] taken;

  private TargetFinder(CameraFrame frame) {
    width = frame.width();
    height = frame.height();
    rgb = frame.pixels();
    taken = new boolean[width * height];
    long[] sum = new long[3];
    int count = 0;
    for (int i = 0; i < width * height; i += 7) {
      for (int c = 0; c < 3; c++) {
        sum[c] += rgb[3 * i + c] & 0xff;
      }
      count++;
    }
    for (int c = 0; c < 3; c++) {
      mean[c] = (int) (sum[c] / count);
    }
  }

  /**
   * Patches in an image.
   *
   * @param leastPx size of the smallest target [px]
   * @param mostPx size of the largest target [px]
   */
  static List<TargetPatch> in(CameraFrame frame, double leastPx, double mostPx) {
    return new TargetFinder(frame).search(leastPx, mostPx);
  }

  private List<TargetPatch> search(double leastPx, double mostPx) {
    List<TargetPatch> patches = new ArrayList<>();
    for (int row = 1; row < height; row += COARSE) {
      for (int column = 1; column < width && patches.size() < MAX_PATCHES; column += COARSE) {
        int at = row * width + column;
        if (!taken[at] && standsOut(at)) {
          TargetPatch patch = flood(at, (int) (mostPx * mostPx));
          if (patch != null
              && Math.max(patch.width(), patch.height()) <= mostPx
              && Math.min(patch.width(), patch.height()) >= leastPx) {
            patches.add(patch);
          }
        }
      }
    }
    return patches;
  }

  /** Whether a pixel differs from the ground in hue, or strongly in brightness. */
  private boolean standsOut(int at) {
    int red = (rgb[3 * at] & 0xff) - mean[0];
    int green = (rgb[3 * at + 1] & 0xff) - mean[1];
    int blue = (rgb[3 * at + 2] & 0xff) - mean[2];
    return Math.abs(red) + Math.abs(green) + Math.abs(blue) > STANDS_OUT;
  }

  /** The patch around a pixel; null if it is too large or reaches the edge of the image. */
  private TargetPatch flood(int start, int mostPixels) {
    int[] queue = new int[mostPixels + 8];
    int count = 0;
    queue[count++] = start;
    taken[start] = true;
    int left = width;
    int right = 0;
    int top = height;
    int bottom = 0;
    boolean isWhole = true;
    for (int next = 0; next < count; next++) {
      int x = queue[next] % width;
      int y = queue[next] / width;
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = Math.max(bottom, y);
      isWhole &= x > 0 && y > 0 && x < width - 1 && y < height - 1;
      for (int k = 0; k < 9; k++) { // single pixels may be missing on an edge
        int nx = x + k % 3 - 1;
        int ny = y + k / 3 - 1;
        if (nx >= 0 && ny >= 0 && nx < width && ny < height) {
          int at = ny * width + nx;
          if (!taken[at] && standsOut(at)) {
            taken[at] = true;
            if (count == queue.length) {
              return null;
            }
            queue[count++] = at;
          }
        }
      }
    }
    return isWhole ? patch(queue, count, left, top, right - left + 1, bottom - top + 1) : null;
  }

  private TargetPatch patch(int[] pixels, int count, int left, int top, int wide, int high) {
    boolean[] isOn = new boolean[wide * high];
    for (int i = 0; i < count; i++) {
      isOn[(pixels[i] / width - top) * wide + pixels[i] % width - left] = true;
    }
    fill(isOn, wide, high);
    double column = 0.0;
    double row = 0.0;
    int area = 0;
    for (int i = 0; i < isOn.length; i++) {
      if (isOn[i]) {
        column += left + i % wide;
        row += top + i / wide;
        area++;
      }
    }
    return new TargetPatch(left, top, wide, high, isOn, area, column / area, row / area);
  }

  /** Fills holes, i.e. pixels not connected to the outside of the box. */
  private static void fill(boolean[] isOn, int wide, int high) {
    boolean[] outside = new boolean[isOn.length];
    int[] queue = new int[isOn.length];
    int count = 0;
    for (int i = 0; i < isOn.length; i++) {
      int x = i % wide;
      int y = i / wide;
      if (!isOn[i] && (x == 0 || y == 0 || x == wide - 1 || y == high - 1)) {
        outside[i] = true;
        queue[count++] = i;
      }
    }
    for (int next = 0; next < count; next++) {
      int x = queue[next] % wide;
      int[] near = {queue[next] - wide, queue[next] + wide, queue[next] - 1, queue[next] + 1};
      for (int k = 0; k < 4; k++) {
        int at = near[k];
        boolean wraps = k == 2 && x == 0 || k == 3 && x == wide - 1;
        if (!wraps && at >= 0 && at < isOn.length && !isOn[at] && !outside[at]) {
          outside[at] = true;
          queue[count++] = at;
        }
      }
    }
    for (int i = 0; i < isOn.length; i++) {
      isOn[i] = !outside[i];
    }
  }
}
