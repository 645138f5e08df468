package org.u2sa.messages.schema;

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
      if (!Double.isFinite(value)) {
        throw ScalarKinds.expected("finite numbers, not " + value);
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

  /** The number at an index, as such. */
  double at(int index) {
    return values[index];
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
