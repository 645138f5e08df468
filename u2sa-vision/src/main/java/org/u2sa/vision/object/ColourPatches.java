package org.u2sa.vision.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.device.port.CameraFrame.PixelFormat;

/**
 * Finds connected colour patches in every second pixel of every second row, by run-based labelling
 * (Rosenfeld and Pfaltz, Sequential Operations in Digital Picture Processing, J. ACM 13, 1966).
 * Reuses its buffers.
 */
final class ColourPatches {
  private static final int BITS = 5; // per colour channel in the table
  private static final int SHIFT = 8 - BITS;
  private static final int LEAST = 6; // minimum subsampled pixels of a patch

  private final ColourClass[] classes = ColourClass.values();
  private final byte[] table = new byte[1 << 3 * BITS];
  private byte[] classOf = new byte[0];
  private int[] label = new int[0];
  private int[] parent = new int[1024];
  private int[] bounds = new int[0]; // left, top, right, bottom, count, class of each label

  ColourPatches() {
    int levels = 1 << BITS;
    double half = 0.5 * (1 << SHIFT);
    for (int i = 0; i < table.length; i++) {
      double red = (i >> 2 * BITS << SHIFT) + half;
      double green = (i >> BITS & levels - 1) * (1 << SHIFT) + half;
      double blue = (i & levels - 1) * (1 << SHIFT) + half;
      table[i] = (byte) ColourClass.of(red, green, blue).ordinal();
    }
  }

  /** Patches of an image; none if it is greyscale. Bounds are in full resolution. */
  List<ColourPatch> find(CameraFrame frame) {
    if (frame.format() != PixelFormat.RGB24) {
      return List.of();
    }
    int width = (frame.width() + 1) / 2;
    int height = (frame.height() + 1) / 2;
    if (classOf.length < width * height) {
      classOf = new byte[width * height];
      label = new int[width * height];
    }
    classify(frame, width, height);
    int labels = join(width, height);
    return measure(width, height, labels, frame);
  }

  private void classify(CameraFrame frame, int width, int height) {
    byte[] rgb = frame.pixels();
    for (int row = 0; row < height; row++) {
      int at = 3 * 2 * row * frame.width();
      for (int cell = row * width; cell < (row + 1) * width; cell++, at += 6) {
        int red = (rgb[at] & 0xFF) >> SHIFT;
        int green = (rgb[at + 1] & 0xFF) >> SHIFT;
        int blue = (rgb[at + 2] & 0xFF) >> SHIFT;
        classOf[cell] = table[red << 2 * BITS | green << BITS | blue];
      }
    }
  }

  private int join(int width, int height) {
    int labels = 0;
    for (int row = 0; row < height; row++) {
      for (int column = 0, cell = row * width; column < width; column++, cell++) {
        byte own = classOf[cell];
        if (own == 0) {
          continue;
        }
        int left = column > 0 && classOf[cell - 1] == own ? label[cell - 1] : -1;
        int above = row > 0 && classOf[cell - width] == own ? label[cell - width] : -1;
        if (left < 0 && above < 0) {
          if (labels == parent.length) {
            parent = Arrays.copyOf(parent, 2 * labels);
          }
          parent[labels] = labels;
          label[cell] = labels++;
        } else if (left >= 0 && above >= 0) {
          int a = root(left);
          int b = root(above);
          parent[Math.max(a, b)] = Math.min(a, b);
          label[cell] = Math.min(a, b);
        } else {
          label[cell] = Math.max(left, above);
        }
      }
    }
    return labels;
  }

  private int root(int of) {
    int root = of;
    while (parent[root] != root) {
      parent[root] = parent[parent[root]];
      root = parent[root];
    }
    return root;
  }

  private List<ColourPatch> measure(int width, int height, int labels, CameraFrame frame) {
    if (bounds.length < 6 * labels) {
      bounds = new int[6 * parent.length];
    }
    for (int i = 0; i < labels; i++) {
      bounds[6 * i] = Integer.MAX_VALUE;
      bounds[6 * i + 1] = Integer.MAX_VALUE;
      Arrays.fill(bounds, 6 * i + 2, 6 * i + 6, 0);
    }
    for (int row = 0; row < height; row++) {
      for (int column = 0, cell = row * width; column < width; column++, cell++) {
        if (classOf[cell] != 0) {
          int at = 6 * root(label[cell]);
          bounds[at] = Math.min(bounds[at], column);
          bounds[at + 1] = Math.min(bounds[at + 1], row);
          bounds[at + 2] = Math.max(bounds[at + 2], column);
          bounds[at + 3] = row;
          bounds[at + 4]++;
          bounds[at + 5] = classOf[cell];
        }
      }
    }
    List<ColourPatch> patches = new ArrayList<>();
    for (int i = 0; i < labels; i++) {
      int at = 6 * i;
      if (bounds[at + 4] >= LEAST) {
        patches.add(
            new ColourPatch(
                classes[bounds[at + 5]],
                2 * bounds[at],
                2 * bounds[at + 1],
                Math.min(frame.width() - 1, 2 * bounds[at + 2] + 1),
                Math.min(frame.height() - 1, 2 * bounds[at + 3] + 1),
                4 * bounds[at + 4]));
      }
    }
    return patches;
  }

  /**
   * Bounding box of connected pixels of one colour in the image [px], inclusive.
   *
   * @param count number of pixels of the colour
   */
  record ColourPatch(ColourClass colour, int left, int top, int right, int bottom, int count) {
    int width() {
      return right - left + 1;
    }

    int height() {
      return bottom - top + 1;
    }

    /** Overlap in columns, as a fraction of the narrower patch. */
    double overlap(ColourPatch other) {
      int common = Math.min(right, other.right) - Math.max(left, other.left) + 1;
      return Math.max(0.0, (double) common / Math.min(width(), other.width()));
    }

    /** Vertical gap in rows; negative if they overlap. */
    int rowsBetween(ColourPatch other) {
      return Math.max(top, other.top) - Math.min(bottom, other.bottom) - 1;
    }

    ColourPatch with(ColourPatch other) {
      return new ColourPatch(
          colour,
          Math.min(left, other.left),
          Math.min(top, other.top),
          Math.max(right, other.right),
          Math.max(bottom, other.bottom),
          count + other.count);
    }
  }

  /** Colours that identify objects on a course. The ordinal is the class number. */
  enum ColourClass {
    OTHER,
    /** Barrels and sawhorses. */
    ORANGE,
    /** Red flags. */
    RED,
    /** Blue flags. */
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
        double hue =
            60.0 * (green - blue) / Math.max(1.0, range); // [deg], -60 magenta to 60 yellow
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
}
