package org.u2sa.report.page;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.interfaces.JsonText;

/** A quantity over time, decimated for drawing: each interval keeps its minimum and maximum. */
public final class Trace {
  private static final int MAX_POINTS = 1_600;
  private static final double LARGE = 1e12; // far beyond, a long would overflow
  private static final double DIGITS = 1e5;
  private static final double SMALL = 1e-3;
  private static final MathContext SMALL_DIGITS = new MathContext(6);

  private final String name;
  private double[] times = new double[256];
  private double[] values = new double[256];
  private int size;

  /** Creates an empty trace. */
  public Trace(String name) {
    this.name = name;
  }

  /** Name of the quantity. */
  public String name() {
    return name;
  }

  /** Adds a value at a time of the run [s]; times must not decrease. */
  public void add(double timeS, double value) {
    if (size == times.length) {
      times = Arrays.copyOf(times, 2 * size);
      values = Arrays.copyOf(values, 2 * size);
    }
    times[size] = timeS;
    values[size++] = value;
  }

  /** Number of values. */
  public int size() {
    return size;
  }

  /** Time of a value [s of the run]. */
  public double time(int index) {
    return times[index];
  }

  public double value(int index) {
    return values[index];
  }

  /** Quantile of the values by nearest rank; 0 if empty. */
  public double quantile(double share) {
    if (size == 0) {
      return 0.0;
    }
    double[] sorted = Arrays.copyOf(values, size);
    Arrays.sort(sorted);
    return sorted[Math.max(0, (int) Math.ceil(share * size) - 1)];
  }

  /** Root mean square; 0 if empty. */
  public double rootMeanSquare() {
    double sum = 0.0;
    for (int i = 0; i < size; i++) {
      sum += values[i] * values[i];
    }
    return size == 0 ? 0.0 : Math.sqrt(sum / size);
  }

  /** Largest absolute value; 0 if empty. */
  public double greatestMagnitude() {
    double greatest = 0.0;
    for (int i = 0; i < size; i++) {
      greatest = Math.max(greatest, Math.abs(values[i]));
    }
    return greatest;
  }

  /** The points to draw, in order. */
  public int[] kept() {
    if (size <= MAX_POINTS) {
      int[] all = new int[size];
      for (int i = 0; i < size; i++) {
        all[i] = i;
      }
      return all;
    }
    int stretches = MAX_POINTS / 2;
    List<Integer> kept = new ArrayList<>();
    for (int s = 0; s < stretches; s++) {
      int from = (int) ((long) s * size / stretches);
      int to = (int) ((long) (s + 1) * size / stretches);
      int least = from;
      int greatest = from;
      for (int i = from; i < to; i++) {
        least = values[i] < values[least] ? i : least;
        greatest = values[i] > values[greatest] ? i : greatest;
      }
      kept.add(Math.min(least, greatest));
      if (least != greatest) {
        kept.add(Math.max(least, greatest));
      }
    }
    return kept.stream().mapToInt(Integer::intValue).toArray();
  }

  JsonText json() {
    List<Double> t = new ArrayList<>();
    List<Double> v = new ArrayList<>();
    for (int i : kept()) {
      t.add(Math.round(times[i] * 1e3) / 1e3);
      v.add(rounded(values[i]));
    }
    return new JsonText().put("name", name).put("t", t).put("v", v);
  }

  /**
   * Five decimals are finer than visible and keep the file small. Very small numbers keep six
   * significant digits instead; very large ones, such as timestamps, are not rounded.
   */
  public static double rounded(double value) {
    if (Math.abs(value) > LARGE) {
      return value;
    }
    return Math.abs(value) < SMALL
        ? BigDecimal.valueOf(value).round(SMALL_DIGITS).doubleValue()
        : Math.round(value * DIGITS) / DIGITS;
  }
}
