package org.u2sa.core.planning.search;

import java.nio.ByteBuffer;

/**
 * Where a row of bytes differs from what it was before. Rows that are the same, as most are, cost
 * next to nothing: buffers are compared many bytes at a time.
 */
public final class RowChange {
  private int first;
  private int last;

  /**
   * Looks for differences.
   *
   * @param begin index of the row's first byte in both arrays
   * @param length of the row
   * @return whether there are any
   */
  public boolean find(byte[] before, byte[] after, int begin, int length) {
    if (ByteBuffer.wrap(before, begin, length).equals(ByteBuffer.wrap(after, begin, length))) {
      return false;
    }
    first = 0;
    while (before[begin + first] == after[begin + first]) {
      first++;
    }
    last = length - 1;
    while (before[begin + last] == after[begin + last]) {
      last--;
    }
    return true;
  }

  /** The first that differs, counted from the row's begin, if any did. */
  public int first() {
    return first;
  }

  /** The last one. */
  public int last() {
    return last;
  }
}
