package org.u2sa.messages.cbor;

import java.util.AbstractList;
import java.util.Collection;
import java.util.RandomAccess;

/** An immutable list of booleans, one byte each. */
public final class Flags extends AbstractList<Boolean> implements RandomAccess {
  private final boolean[] values;

  private Flags(boolean[] values) {
    this.values = values;
  }

  /** Wraps the array, which the caller must not modify afterwards. */
  public static Flags owning(boolean[] values) {
    return new Flags(values);
  }

  /**
   * The same values.
   *
   * @throws IllegalArgumentException if one is neither true nor false
   */
  public static Flags of(Collection<?> flags) {
    if (flags instanceof Flags same) {
      return same;
    }
    boolean[] values = new boolean[flags.size()];
    int count = 0;
    for (Object flag : flags) {
      if (!(flag instanceof Boolean value)) {
        throw Limits.expected("a list of true or false");
      }
      values[count++] = value;
    }
    return new Flags(values);
  }

  boolean at(int index) {
    return values[index];
  }

  @Override
  public Boolean get(int index) {
    return values[index];
  }

  @Override
  public int size() {
    return values.length;
  }
}
