package org.u2sa.recorder.execution;

import java.util.Arrays;

/**
 * A number of one source's messages on a channel: in the recording, and when the service was
 * executed again. Begins with the first message in which the two differ.
 */
public final class NumberComparison {
  private static final int VALUES = 3; // of a message: when, recorded, now

  private final String name;
  private final String unit;
  private final double turn; // a full one, if the number is an angle or a longitude; otherwise 0
  private double[] values = new double[VALUES * 64];
  private int size; // messages
  private long pairs;
  private double sumOfSquares;
  private double largest;

  /** Takes the messages that have the number. */
  @FunctionalInterface
  public interface Taker {
    /**
     * @param timeS when it was published [s of the run's clock]
     * @param recorded NaN: not in the recording
     * @param now NaN: not published now
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

  /** What is now less what was recorded, in the unit; of angles the shorter way round. */
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

  /** Root of the mean square deviation, in the unit; 0 if no message is in both. */
  public double rms() {
    return pairs == 0 ? 0.0 : Math.sqrt(sumOfSquares / pairs);
  }

  /** The largest deviation, without sign, in the unit. */
  public double largest() {
    return largest;
  }

  /** All messages, in the order in which they came. */
  public void forEach(Taker taker) {
    for (int i = 0; i < size; i++) {
      taker.take(values[VALUES * i], values[VALUES * i + 1], values[VALUES * i + 2]);
    }
  }
}
