package org.u2sa.vision.survey;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.device.port.CameraFrame;

/** Trains the model of shapes and letters: means over the patches of known targets. */
public final class TargetTraining {
  static final double SCALE = 1_000.0; // numbers in the file are thousandths

  private final Map<String, double[]> sums = new TreeMap<>();
  private final Map<String, Integer> counts = new TreeMap<>();

  /**
   * Learns from an image that shows one target.
   *
   * @param upRad direction of the letter's top, clockwise from the top of the image [rad]
   * @return false if no target was found
   */
  public boolean learn(CameraFrame frame, String shape, String letter, double upRad) {
    List<TargetPatch> patches = TargetFinder.in(frame, 10.0, 200.0);
    if (patches.size() != 1) {
      return false;
    }
    TargetPatch patch = patches.get(0);
    double[] outline = TargetFeatures.outline(patch);
    double[] turned = new double[outline.length];
    int turn = (int) Math.round(upRad / (2.0 * Math.PI) * outline.length);
    for (int i = 0; i < outline.length; i++) {
      turned[i] = outline[Math.floorMod(i + turn, outline.length)];
    }
    add("SHAPE " + shape, turned);
    add(
        "LETTER " + letter,
        TargetFeatures.letter(patch, new TargetColours(frame, patch).ink(), upRad));
    return true;
  }

  private void add(String name, double[] values) {
    double[] sum = sums.computeIfAbsent(name, any -> new double[values.length]);
    for (int i = 0; i < values.length; i++) {
      sum[i] += values[i];
    }
    counts.merge(name, 1, Integer::sum);
  }

  /** The model as text. */
  public String model() {
    StringBuilder text = new StringBuilder();
    for (Map.Entry<String, double[]> each : sums.entrySet()) {
      double[] mean = each.getValue().clone();
      for (int i = 0; i < mean.length; i++) {
        mean[i] /= counts.get(each.getKey());
      }
      if (each.getKey().startsWith("LETTER")) {
        TargetFeatures.normalised(mean, 0.0);
      }
      text.append(each.getKey());
      for (double value : mean) {
        text.append(String.format(Locale.ROOT, " %d", Math.round(SCALE * value)));
      }
      text.append('\n');
    }
    return text.toString();
  }
}
