package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.util.AbstractList;
import java.util.Collection;
import java.util.RandomAccess;

/** An immutable list of finite numbers that needs no object for each of them. */
final class Numbers extends AbstractList<Double> implements RandomAccess {
  private final double[] values;

  private Numbers(double[] values) {
    this.values = values;
  }

  /**
   * These numbers; nobody else changes the array any more.
   *
   * @throws IllegalArgumentException if one is not finite
   */
  static Numbers owning(double[] values) {
    for (double value : values) {
      if (!(Math.abs(value) <= Limits.NUMBER)) { // NaN, too
        String bound = Double.isFinite(value) ? " of at most " + Limits.NUMBER : "";
        throw ScalarKinds.expected("finite numbers" + bound + ", not " + value);
      }
    }
    return new Numbers(values);
  }

  /**
   * The same numbers.
   *
   * @throws IllegalArgumentException if one is not finite, or no number at all
   */
  static Numbers of(Collection<?> numbers) {
    if (numbers instanceof Numbers same) {
      return same;
    }
    double[] values = new double[numbers.size()];
    int count = 0;
    for (Object number : numbers) {
      if (!(number instanceof Double value)) {
        throw ScalarKinds.expected("a list of numbers");
      }
      values[count++] = value;
    }
    return owning(values);
  }

  /**
   * Writes them as float64, for which there must be room.
   *
   * @return where they end
   */
  int put(byte[] bytes, int start) {
    ByteBuffer into = ByteBuffer.wrap(bytes); // nobody else's: compilers leave it out
    int at = start;
    for (double value : values) {
      bytes[at] = (byte) Cbor.FLOAT_64;
      into.putDouble(at + 1, value);
      at += 1 + Double.BYTES;
    }
    return at;
  }

  /** Writes them one behind the other in the order of bytes that the buffer has. */
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
