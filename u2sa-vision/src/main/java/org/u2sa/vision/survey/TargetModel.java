package org.u2sa.vision.survey;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.BadInputException;

/**
 * Average appearance of shapes and letters; the most similar one in any direction is chosen. Stored
 * in {@code targets.model}: lines of SHAPE or LETTER, a name, and numbers; created by {@link
 * TargetTraining}.
 */
final class TargetModel {
  private static final String FILE = "targets.model";
  private static final int TURNS = 36;
  private static final double MIN_LIKENESS = 0.35;

  private final Map<String, double[]> shapes = new TreeMap<>();
  private final Map<String, double[]> letters = new TreeMap<>();

  /**
   * A recognised letter.
   *
   * @param name the letter; empty if none is similar
   * @param upRad direction of its top, clockwise from the top of the image [rad]
   */
  record Read(String name, double upRad) {}

  private TargetModel() {}

  /** The model that ships with this module. */
  static TargetModel shipped() {
    try (InputStream in = TargetModel.class.getResourceAsStream(FILE)) {
      if (in == null) {
        throw new BadInputException(FILE + ": is not on the class path");
      }
      return read(new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static TargetModel read(BufferedReader lines) throws IOException {
    TargetModel model = new TargetModel();
    int number = 0;
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      number++;
      String[] parts = line.trim().split("\\s+");
      boolean isShape = parts[0].equals("SHAPE");
      int expected =
          isShape ? TargetFeatures.DIRECTIONS : TargetFeatures.GRID * TargetFeatures.GRID;
      if (!isShape && !parts[0].equals("LETTER") || parts.length != expected + 2) {
        throw new BadInputException(
            FILE + ", line " + number + ": expected SHAPE or LETTER, a name, and the numbers");
      }
      double[] values = new double[expected];
      for (int i = 0; i < expected; i++) {
        values[i] = Double.parseDouble(parts[i + 2]) / TargetTraining.SCALE;
      }
      (isShape ? model.shapes : model.letters).put(parts[1], values);
    }
    return model;
  }

  /** The most similar shape. */
  String shape(double[] outline) {
    String best = "";
    double least = Double.POSITIVE_INFINITY;
    for (Map.Entry<String, double[]> each : shapes.entrySet()) {
      for (int turn = 0; turn < outline.length; turn++) {
        double sum = 0.0;
        for (int i = 0; i < outline.length; i++) {
          double off = outline[(i + turn) % outline.length] - each.getValue()[i];
          sum += off * off;
        }
        if (sum < least) {
          least = sum;
          best = each.getKey();
        }
      }
    }
    return best;
  }

  /** The most similar letter and its direction. */
  Read letter(TargetPatch patch, boolean[] ink) {
    Read best = new Read("", 0.0);
    double most = MIN_LIKENESS;
    for (int turn = 0; turn < TURNS; turn++) {
      double up = 2.0 * Math.PI * turn / TURNS;
      double[] seen = TargetFeatures.letter(patch, ink, up);
      for (Map.Entry<String, double[]> each : letters.entrySet()) {
        double like = 0.0;
        for (int i = 0; i < seen.length; i++) {
          like += seen[i] * each.getValue()[i];
        }
        if (like > most) {
          most = like;
          best = new Read(each.getKey(), up);
        }
      }
    }
    return best;
  }
}
