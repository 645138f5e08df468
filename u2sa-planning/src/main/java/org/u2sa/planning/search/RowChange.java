package org.u2sa.planning.search;

import java.nio.ByteBuffer;

/**
 * Finds the range in which a row of bytes has changed. Compares blockwise from both ends, because
 * most bytes are equal.
 */
public final class RowChange {
  private static final int BLOCK = 64; // bytes compared at a time

  private int first;
  private int last;

  /**
   * Finds the first and last difference.
   *
   * @param begin index of the row's first byte in both arrays
   * @param length length of the row
   * @return whether there are any
   */
  public boolean find(byte[] before, byte[] after, int begin, int length) {
    int end = begin + length;
    if (isSame(before, after, begin, end)) {
      return false;
    }
    int from = begin;
    while (end - from > BLOCK && isSame(before, after, from, from + BLOCK)) {
      from += BLOCK;
    }
    while (before[from] == after[from]) {
      from++;
    }
    while (end - from > BLOCK && isSame(before, after, end - BLOCK, end)) {
      end -= BLOCK;
    }
    while (before[end - 1] == after[end - 1]) {
      end--;
    }
    first = from - begin;
    last = end - 1 - begin;
    return true;
  }

  private static boolean isSame(byte[] before, byte[] after, int from, int to) {
    return ByteBuffer.wrap(before, from, to - from).equals(ByteBuffer.wrap(after, from, to - from));
  }

  /** Index of the first difference in the row, if any. */
  public int first() {
    return first;
  }

  /** Index of the last difference in the row, if any. */
  public int last() {
    return last;
  }
}
