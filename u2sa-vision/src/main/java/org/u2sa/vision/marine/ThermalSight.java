package org.u2sa.vision.marine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.lens.LensCalibration;

/** Detects warm targets in grey pictures whose values are temperatures. Not thread-safe. */
final class ThermalSight {
  private static final int FEWEST = 6; // pixels
  private static final double FULL = 255.0;
  private static final double SOLID = 0.55; // min. share of its bounding box

  private final ThermalVariables settings;

  /**
   * A warm target.
   *
   * @param thing its direction and distance
   * @param excessK its temperature above the air's [K]
   */
  record Warm(SeenThing thing, double excessK) {}

  ThermalSight(ThermalVariables settings) {
    this.settings = settings;
  }

  List<Warm> look(CameraFrame frame, LensCalibration lens) {
    List<Warm> found = new ArrayList<>();
    if (frame.format() != CameraFrame.PixelFormat.GREY8) {
      return found;
    }
    int width = frame.width();
    int height = frame.height();
    double perStep = (settings.hottest() - settings.coldest()) / FULL;
    double air = (settings.airTemperature() - settings.coldest()) / perStep;
    int least = (int) Math.ceil(air + settings.minExcess() / perStep);
    boolean[] done = new boolean[frame.pixels().length];
    for (int start = 0; start < done.length; start++) {
      if (!done[start] && (frame.pixels()[start] & 0xFF) >= least) {
        int[] box = {width, height, -1, -1, 0, 0};
        flood(frame, least, start, done, box);
        boolean isWhole = box[0] > 0 && box[1] > 0 && box[2] < width - 1 && box[3] < height - 1;
        boolean isSolid =
            box[4] >= SOLID * (box[2] - box[0] + 1) * (box[3] - box[1] + 1) && box[4] >= FEWEST;
        if (isWhole && isSolid) {
          warm(box, ((double) box[5] / box[4] - air) * perStep, lens, found);
        }
      }
    }
    return found;
  }

  /** Box of the connected warm pixels: left, top, right, bottom, count, sum of values. */
  private static void flood(CameraFrame frame, int least, int start, boolean[] done, int[] box) {
    int width = frame.width();
    ArrayDeque<Integer> open = new ArrayDeque<>(Arrays.asList(start));
    done[start] = true;
    while (!open.isEmpty()) {
      int at = open.pop();
      int x = at % width;
      int y = at / width;
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
      box[4]++;
      box[5] += frame.pixels()[at] & 0xFF;
      int[] next = {
        x > 0 ? at - 1 : -1,
        x < width - 1 ? at + 1 : -1,
        at - width,
        at + width < done.length ? at + width : -1
      };
      for (int to : next) {
        if (to >= 0 && !done[to] && (frame.pixels()[to] & 0xFF) >= least) {
          done[to] = true;
          open.push(to);
        }
      }
    }
  }

  private void warm(int[] box, double excessK, LensCalibration lens, List<Warm> found) {
    double x = 0.5 * (box[0] + box[2]);
    double y = 0.5 * (box[1] + box[3]);
    double rows = box[3] - box[1] + 1.0;
    Point way = MarineSight.wayOfPixel(lens, x, y).orElse(null);
    Point top = MarineSight.wayOfPixel(lens, x, y - 0.5 * rows).orElse(null);
    Point bottom = MarineSight.wayOfPixel(lens, x, y + 0.5 * rows).orElse(null);
    if (way == null || top == null || bottom == null) {
      return;
    }
    double half = Math.asin(0.5 * top.distanceTo(bottom));
    double range = 0.5 * settings.targetHeight() / Math.tan(half);
    double sigma = range * Math.hypot(settings.sizeSigma(), settings.pixelSigma() / rows);
    if (range <= settings.maxDistance()) {
      double confidence = 0.6 + 0.35 * Math.min(1.0, box[4] / 60.0);
      found.add(
          new Warm(
              new SeenThing(
                  MarineKind.HOT_TARGET,
                  Optional.empty(),
                  way,
                  range,
                  sigma,
                  Optional.empty(),
                  confidence),
              excessK));
    }
  }
}
