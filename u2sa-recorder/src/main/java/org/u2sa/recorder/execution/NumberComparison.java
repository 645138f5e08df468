package org.u2sa.recorder.execution;

import java.util.Arrays;

/**
 * Compares one number of one source's messages on a channel between the recording and the
 * re-execution, starting with the first message in which they differ.
 */
public final class NumberComparison {
  private static final int VALUES = 3; // per message: time, recorded, now

  private final String name;
  private final String unit;
  private final double turn; // full turn of an angle or longitude; otherwise 0
  private double[] values = new double[VALUES * 64];
  private int size; // messages
  private long pairs;
  private double sumOfSquares;
  private double largest;

  /** Receives the messages with this number. */
  @FunctionalInterface
  public interface Taker {
    /**
     * @param timeS publication time [s of the run's clock]
     * @param recorded recorded value; NaN if absent
     * @param now value from the re-execution; NaN if absent
     */
    void take(double timeS, double recorded, double now);
  }

  NumberComparison(String name, String unit) {
    this.name = name;
    this.unit = unit;
    turn = unit.equals("rad") ? 2.0 * Math.PI : unit.equals("deg") ? 360.0 : 0.0;
  }

  void add(double timeS, double recorded, double now) {
    if (VALUES * size == values.length) {
      values = Arrays.copyOf(values, 2 * values.length);
    }
    values[VALUES * size] = timeS;
    values[VALUES * size + 1] = recorded;
    values[VALUES * size + 2] = now;
    size++;
    double deviation = deviation(recorded, now);
    if (!Double.isNaN(deviation)) {
      pairs++;
      sumOfSquares += deviation * deviation;
      largest = Math.max(largest, Math.abs(deviation));
    }
  }

  /** New value minus recorded value, in the unit; angles by the shorter way round. */
  public double deviation(double recorded, double now) {
    return turn == 0.0 ? now - recorded : Math.IEEEremainder(now - recorded, turn);
  }

  /** Path of the field, such as {@code point.x}, and the source if the channel has several. */
  public String name() {
    return name;
  }

  /** "m", "rad", …; empty if it has none. */
  public String unit() {
    return unit;
  }

  /** RMS deviation, in the unit; 0 if no message is in both. */
  public double rms() {
    return pairs == 0 ? 0.0 : Math.sqrt(sumOfSquares / pairs);
  }

  /** Largest absolute deviation, in the unit. */
  public double largest() {
    return largest;
  }

  /** Passes on all messages, in order. */
  public void forEach(Taker taker) {
    for (int i = 0; i < size; i++) {
      taker.take(values[VALUES * i], values[VALUES * i + 1], values[VALUES * i + 2]);
    }
  }
}
