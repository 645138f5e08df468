package org.u2sa.gcs.export;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;

/** Leaves out what comes too soon after what was last taken of the same kind. */
final class Spacing {
  private final double everyS;
  private final Map<Object, Double> takenS = new HashMap<>();

  /**
   * @param everyS least time between two that are taken [s]; 0: all are
   */
  Spacing(double everyS) {
    this.everyS = everyS;
  }

  /** Whether a message is to be taken at that time [s]; each source of a topic counts by itself. */
  boolean takes(Topic topic, U2SAData message, double timeS) {
    String source = Channels.namedOrNew(topic.channel()).sourceOf(message);
    return takes(List.of(topic, source), timeS);
  }

  /** Whether one of that kind is to be taken at that time [s]. */
  boolean takes(Object kind, double timeS) {
    Double last = takenS.get(kind);
    if (last != null && timeS < last + everyS) {
      return false;
    }
    takenS.put(kind, timeS);
    return true;
  }
}
