package org.u2sa.vision.survey;

import java.util.Arrays;
import org.u2sa.device.port.CameraFrame;

/** The two colours of a target: those of its shape and its letter. */
final class TargetColours {
  private static final String[] NAMES = {
    "white", "black", "red", "blue", "yellow", "orange", "purple"
  };
  private static final int[][] RGB = {
    {235, 235, 235},
    {25, 25, 25},
    {200, 30, 35},
    {35, 60, 190},
    {235, 215, 40},
    {240, 125, 25},
    {120, 40, 150}
  };
  private static final double LETTER_SHARE = 0.12; // share of the patch's pixels that differ most
  private static final double MIN_APART = 35.0;

  private final double[] shape = new double[3];
  private final double[] letter = new double[3];
  private final boolean[] isInk;

  TargetColours(CameraFrame frame, TargetPatch patch) {
    isInk = new boolean[patch.isOn().length];
    boolean[] inner = inner(patch);
    int count = 0;
    int[] at = new int[isInk.length];
    for (int i = 0; i < isInk.length; i++) {
      if (inner[i]) {
        at[count++] = i;
      }
    }
    if (count < 12) {
      return;
    }
    median(frame, patch, at, count);
    Integer[] order = new Integer[count];
    double[] apart = new double[count];
    for (int k = 0; k < count; k++) {
      order[k] = k;
      apart[k] = distance(frame, pixel(frame, patch, at[k]), shape);
    }
    Arrays.sort(order, (a, b) -> Double.compare(apart[b], apart[a]));
    int most = Math.max(4, (int) (LETTER_SHARE * count));
    for (int k = 0; k < most; k++) {
      for (int c = 0; c < 3; c++) {
        letter[c] += (frame.pixels()[pixel(frame, patch, at[order[k]]) + c] & 0xff) / (double) most;
      }
    }
    for (int k = 0; k < count; k++) {
      isInk[at[k]] = distance(frame, pixel(frame, patch, at[k]), letter) < apart[k];
    }
  }

  /** Interior pixels of the patch, whose colours are not mixed with the ground's. */
  private static boolean[] inner(TargetPatch patch) {
    boolean[] inner = new boolean[patch.isOn().length];
    int wide = patch.width();
    for (int y = 2; y < patch.height() - 2; y++) {
      for (int x = 2; x < wide - 2; x++) {
        boolean all = true;
        for (int k = 0; k < 25; k++) {
          all &= patch.isOn()[(y + k / 5 - 2) * wide + x + k % 5 - 2];
        }
        inner[y * wide + x] = all;
      }
    }
    return inner;
  }

  /** The shape's colour: the median of each channel, because the letter covers less than half. */
  private void median(CameraFrame frame, TargetPatch patch, int[] at, int count) {
    int[] values = new int[count];
    for (int c = 0; c < 3; c++) {
      for (int k = 0; k < count; k++) {
        values[k] = frame.pixels()[pixel(frame, patch, at[k]) + c] & 0xff;
      }
      Arrays.sort(values);
      shape[c] = values[count / 2];
    }
  }

  private static int pixel(CameraFrame frame, TargetPatch patch, int at) {
    int y = patch.top() + at / patch.width();
    int x = patch.left() + at % patch.width();
    return 3 * (y * frame.width() + x);
  }

  private static double distance(CameraFrame frame, int pixel, double[] colour) {
    double sum = 0.0;
    for (int c = 0; c < 3; c++) {
      double off = (frame.pixels()[pixel + c] & 0xff) - colour[c];
      sum += off * off;
    }
    return Math.sqrt(sum);
  }

  private static double apart(double[] a, double[] b) {
    return Math.sqrt(
        (a[0] - b[0]) * (a[0] - b[0])
            + (a[1] - b[1]) * (a[1] - b[1])
            + (a[2] - b[2]) * (a[2] - b[2]));
  }

  private static String name(double[] colour) {
    int best = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < NAMES.length; i++) {
      double away = apart(colour, new double[] {RGB[i][0], RGB[i][1], RGB[i][2]});
      if (away < least) {
        least = away;
        best = i;
      }
    }
    return NAMES[best];
  }

  String shapeColour() {
    return name(shape);
  }

  String letterColour() {
    return name(letter);
  }

  /** Whether the patch has two colours. */
  boolean hasLetter() {
    return apart(shape, letter) > MIN_APART;
  }

  /** Pixels of the letter, row by row in the patch's box. */
  boolean[] ink() {
    return isInk;
  }
}
