package org.u2sa.recorder;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.Map;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionPart;

/**
 * Where in the present file the messages of late are, so that an execution can refer to them.
 * Belongs to one thread.
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
      places.remove(oldest.message, oldest.place); // unless it was published once more since
    }
  }

  /** The place of that very object; null if it is not among those of late. */
  ExecutionPart.Place place(U2SAData message) {
    return places.get(message);
  }

  void clear() {
    places.clear();
    kept.clear();
  }
}
