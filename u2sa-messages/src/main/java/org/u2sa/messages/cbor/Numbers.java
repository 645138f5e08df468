package org.u2sa.messages.cbor;

import java.nio.ByteBuffer;
import java.util.AbstractList;
import java.util.Collection;
import java.util.RandomAccess;

/** An immutable list of unboxed finite numbers. */
public final class Numbers extends AbstractList<Double> implements RandomAccess {
  private final double[] values;

  private Numbers(double[] values) {
    this.values = values;
  }

  /**
   * Wraps the array, which the caller must not modify afterwards.
   *
   * @throws IllegalArgumentException if one is not finite
   */
  public static Numbers owning(double[] values) {
    for (double value : values) {
      if (!(Math.abs(value) <= Limits.NUMBER)) { // true for NaN
        String bound = Double.isFinite(value) ? " of at most " + Limits.NUMBER : "";
        throw Limits.expected("finite numbers" + bound + ", not " + value);
      }
    }
    return new Numbers(values);
  }

  /**
   * The same numbers.
   *
   * @throws IllegalArgumentException if one is not finite, or no number at all
   */
  public static Numbers of(Collection<?> numbers) {
    if (numbers instanceof Numbers same) {
      return same;
    }
    double[] values = new double[numbers.size()];
    int count = 0;
    for (Object number : numbers) {
      if (!(number instanceof Double value)) {
        throw Limits.expected("a list of numbers");
      }
      values[count++] = value;
    }
    return owning(values);
  }

  /**
   * Writes the numbers as float64; the caller ensures space.
   *
   * @return end position
   */
  int put(byte[] bytes, int start) {
    ByteBuffer into = ByteBuffer.wrap(bytes); // local: removed by escape analysis
    int at = start;
    for (double value : values) {
      bytes[at] = (byte) Cbor.FLOAT_64;
      into.putDouble(at + 1, value);
      at += 1 + Double.BYTES;
    }
    return at;
  }

  /** Writes the numbers consecutively in the buffer's byte order. */
  void put(ByteBuffer into) {
    into.asDoubleBuffer().put(values);
  }

  @Override
  public Double get(int index) {
    return values[index];
  }

  @Override
  public int size() {
    return values.length;
  }
}
