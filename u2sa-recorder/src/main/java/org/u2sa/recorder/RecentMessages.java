package org.u2sa.recorder;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Map;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionPart;

/**
 * Positions of recently written messages in the current file, so that an execution can refer to
 * them. Not thread-safe.
 */
final class RecentMessages {
  private record Kept(U2SAData message, ExecutionPart.Place place) {}

  private final Map<U2SAData, ExecutionPart.Place> places = new IdentityHashMap<>();
  private final Deque<Kept> kept = new ArrayDeque<>();

  void add(U2SAData message, ExecutionPart.Place place) {
    places.put(message, place);
    kept.add(new Kept(message, place));
    if (kept.size() > ExecutionPart.REACH) {
      Kept oldest = kept.remove();
      places.remove(oldest.message, oldest.place); // unless published again since
    }
  }

  /** Place of this object (by identity); null if not among the recent messages. */
  ExecutionPart.Place place(U2SAData message) {
    return places.get(message);
  }

  void clear() {
    places.clear();
    kept.clear();
  }
}
