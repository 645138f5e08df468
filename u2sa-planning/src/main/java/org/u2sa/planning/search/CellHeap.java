package org.u2sa.planning.search;

import java.util.Arrays;

/**
 * A binary min-heap of cells with mutable keys. The order of equal keys is deterministic. Not
 * thread-safe.
 */
final class CellHeap {
  private int[] heap = new int[1024];
  private double[] keys = new double[1024];
  private final int[] place; // position of each cell in the heap, from 1; 0 if absent
  private int size;

  CellHeap(int cells) {
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

  double leastKey() {
    return keys[0];
  }

  /** Adds a cell or changes its key. */
  void put(int cell, double key) {
    int at = place[cell] - 1;
    if (at < 0) {
      if (size == heap.length) {
        heap = Arrays.copyOf(heap, 2 * size);
        keys = Arrays.copyOf(keys, 2 * size);
      }
      at = size++;
      rise(at, cell, key);
    } else if (key < keys[at]) {
      rise(at, cell, key);
    } else {
      sink(at, cell, key);
    }
  }

  int poll() {
    int first = heap[0];
    remove(first);
    return first;
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
    double key = keys[size];
    if (at > 0 && key < keys[(at - 1) / 2]) {
      rise(at, moved, key);
    } else {
      sink(at, moved, key);
    }
  }

  private void rise(int from, int cell, double key) {
    int at = from;
    while (at > 0) {
      int parent = (at - 1) / 2;
      if (keys[parent] <= key) {
        break;
      }
      set(at, heap[parent], keys[parent]);
      at = parent;
    }
    set(at, cell, key);
  }

  private void sink(int from, int cell, double key) {
    int at = from;
    while (true) {
      int child = 2 * at + 1;
      if (child >= size) {
        break;
      }
      if (child + 1 < size && keys[child + 1] < keys[child]) {
        child++;
      }
      if (keys[child] >= key) {
        break;
      }
      set(at, heap[child], keys[child]);
      at = child;
    }
    set(at, cell, key);
  }

  private void set(int at, int cell, double key) {
    heap[at] = cell;
    keys[at] = key;
    place[cell] = at + 1;
  }
}
