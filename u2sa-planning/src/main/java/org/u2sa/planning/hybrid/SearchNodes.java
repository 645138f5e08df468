package org.u2sa.planning.hybrid;

import java.util.Arrays;
import org.u2sa.planning.curve.Pose;

/**
 * Nodes of a search over poses, looked up by key, and their priority queue. Not thread-safe; memory
 * is reused for successive searches.
 */
final class SearchNodes {
  static final int NONE = -1;

  private long[] keys = new long[1 << 16]; // open addressing; 0: empty
  private int[] nodes = new int[1 << 16];
  private int count;
  private Pose[] pose = new Pose[1 << 14];
  private double[] cost = new double[1 << 14];
  private int[] parent = new int[1 << 14];
  private int[] move = new int[1 << 14];
  private boolean[] closed = new boolean[1 << 14];
  private int[] heap = new int[1 << 14];
  private double[] order = new double[1 << 14];
  private int waiting;

  void clear() {
    Arrays.fill(keys, 0L);
    count = 0;
    waiting = 0;
  }

  /** Node with a key, which is at least 1; {@link #NONE} if absent. */
  int find(long key) {
    int at = slot(key);
    return keys[at] == key ? nodes[at] : NONE;
  }

  /** Adds a node; one with key 0 cannot be looked up. */
  int add(long key, Pose at, double costM, int from, int by) {
    if (count == pose.length) {
      int more = 2 * count;
      pose = Arrays.copyOf(pose, more);
      cost = Arrays.copyOf(cost, more);
      parent = Arrays.copyOf(parent, more);
      move = Arrays.copyOf(move, more);
      closed = Arrays.copyOf(closed, more);
    }
    int node = count++;
    closed[node] = false;
    set(node, at, costM, from, by);
    if (key != 0L) {
      if (2 * count > keys.length) {
        rehash();
      }
      int slot = slot(key);
      keys[slot] = key;
      nodes[slot] = node;
    }
    return node;
  }

  /** Replaces the path to a node. */
  void set(int node, Pose at, double costM, int from, int by) {
    pose[node] = at;
    cost[node] = costM;
    parent[node] = from;
    move[node] = by;
  }

  Pose pose(int node) {
    return pose[node];
  }

  double cost(int node) {
    return cost[node];
  }

  int parent(int node) {
    return parent[node];
  }

  int move(int node) {
    return move[node];
  }

  boolean isClosed(int node) {
    return closed[node];
  }

  void close(int node) {
    closed[node] = true;
  }

  boolean isEmpty() {
    return waiting == 0;
  }

  /** Queues a node; duplicates are allowed. */
  void push(int node, double priority) {
    if (waiting == heap.length) {
      heap = Arrays.copyOf(heap, 2 * waiting);
      order = Arrays.copyOf(order, 2 * waiting);
    }
    int at = waiting++;
    while (at > 0 && order[(at - 1) / 2] > priority) {
      heap[at] = heap[(at - 1) / 2];
      order[at] = order[(at - 1) / 2];
      at = (at - 1) / 2;
    }
    heap[at] = node;
    order[at] = priority;
  }

  int pop() {
    int first = heap[0];
    int moved = heap[--waiting];
    double priority = order[waiting];
    int at = 0;
    while (2 * at + 1 < waiting) {
      int child = 2 * at + 1;
      if (child + 1 < waiting && order[child + 1] < order[child]) {
        child++;
      }
      if (order[child] >= priority) {
        break;
      }
      heap[at] = heap[child];
      order[at] = order[child];
      at = child;
    }
    heap[at] = moved;
    order[at] = priority;
    return first;
  }

  private int slot(long key) {
    long mixed = key * 0x9E3779B97F4A7C15L; // Fibonacci hashing: Knuth, vol. 3, 6.4
    int at = (int) (mixed >>> 40) & (keys.length - 1);
    while (keys[at] != 0L && keys[at] != key) {
      at = (at + 1) & (keys.length - 1);
    }
    return at;
  }

  private void rehash() {
    long[] oldKeys = keys;
    int[] oldNodes = nodes;
    keys = new long[2 * oldKeys.length];
    nodes = new int[2 * oldKeys.length];
    for (int i = 0; i < oldKeys.length; i++) {
      if (oldKeys[i] != 0L) {
        int at = slot(oldKeys[i]);
        keys[at] = oldKeys[i];
        nodes[at] = oldNodes[i];
      }
    }
  }
}
