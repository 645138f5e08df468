package org.u2sa.planning.search;

import java.util.Arrays;

/**
 * A binary min-heap of cells by two keys in lexicographic order. The order of equal pairs is
 * deterministic. Not thread-safe.
 */
final class PairHeap {
  private int[] heap = new int[1024];
  private double[] first = new double[1024];
  private double[] second = new double[1024];
  private final int[] place; // position of each cell in the heap, from 1; 0 if absent
  private int size;

  PairHeap(int cells) {
    place = new int[cells];
  }

  boolean isEmpty() {
    return size == 0;
  }

  void clear() {
    for (int i = 0; i < size; i++) {
      place[heap[i]] = 0;
    }
    size = 0;
  }

  int first() {
    return heap[0];
  }

  double firstKey() {
    return first[0];
  }

  /** Whether the smallest pair comes before another. */
  boolean isBefore(double one, double other) {
    return isBefore(first[0], second[0], one, other);
  }

  private static boolean isBefore(double a1, double a2, double b1, double b2) {
    return a1 < b1 || (a1 == b1 && a2 < b2);
  }

  void put(int cell, double one, double other) {
    int at = place[cell] - 1;
    if (at < 0) {
      if (size == heap.length) {
        heap = Arrays.copyOf(heap, 2 * size);
        first = Arrays.copyOf(first, 2 * size);
        second = Arrays.copyOf(second, 2 * size);
      }
      rise(size++, cell, one, other);
    } else if (isBefore(one, other, first[at], second[at])) {
      rise(at, cell, one, other);
    } else {
      sink(at, cell, one, other);
    }
  }

  void remove(int cell) {
    int at = place[cell] - 1;
    if (at < 0) {
      return;
    }
    place[cell] = 0;
    size--;
    if (at == size) {
      return;
    }
    int moved = heap[size];
    double one = first[size];
    double other = second[size];
    int parent = (at - 1) / 2;
    if (at > 0 && isBefore(one, other, first[parent], second[parent])) {
      rise(at, moved, one, other);
    } else {
      sink(at, moved, one, other);
    }
  }

  private void rise(int from, int cell, double one, double other) {
    int at = from;
    while (at > 0) {
      int parent = (at - 1) / 2;
      if (!isBefore(one, other, first[parent], second[parent])) {
        break;
      }
      set(at, heap[parent], first[parent], second[parent]);
      at = parent;
    }
    set(at, cell, one, other);
  }

  private void sink(int from, int cell, double one, double other) {
    int at = from;
    while (true) {
      int child = 2 * at + 1;
      if (child >= size) {
        break;
      }
      int right = child + 1;
      if (right < size && isBefore(first[right], second[right], first[child], second[child])) {
        child = right;
      }
      if (!isBefore(first[child], second[child], one, other)) {
        break;
      }
      set(at, heap[child], first[child], second[child]);
      at = child;
    }
    set(at, cell, one, other);
  }

  private void set(int at, int cell, double one, double other) {
    heap[at] = cell;
    first[at] = one;
    second[at] = other;
    place[cell] = at + 1;
  }
}
