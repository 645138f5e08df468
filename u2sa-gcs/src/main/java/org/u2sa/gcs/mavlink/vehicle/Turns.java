package org.u2sa.gcs.mavlink.vehicle;

import java.util.ArrayDeque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Queue;

/** Waiting lines of several owners, who take turns. */
final class Turns<T> {
  private final Map<Object, Queue<T>> lines = new LinkedHashMap<>(); // in the order of their turns

  boolean isEmpty() {
    return lines.isEmpty();
  }

  void add(Object owner, T item) {
    lines.computeIfAbsent(owner, each -> new ArrayDeque<>()).add(item);
  }

  void remove(Object owner) {
    lines.remove(owner);
  }

  /** Removes the first item of the owner whose turn it is, who then comes last. */
  T next() {
    Iterator<Map.Entry<Object, Queue<T>>> turns = lines.entrySet().iterator();
    Map.Entry<Object, Queue<T>> turn = turns.next();
    Object owner = turn.getKey();
    Queue<T> line = turn.getValue();
    turns.remove();
    T item = line.remove();
    if (!line.isEmpty()) {
      lines.put(owner, line);
    }
    return item;
  }
}
