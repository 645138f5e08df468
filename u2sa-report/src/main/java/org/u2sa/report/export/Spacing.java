package org.u2sa.report.export;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;

/** Thins items by a minimum time spacing per kind. */
final class Spacing {
  private static final double ROUNDING_S = 1e-6; // of times, which are sums of a period

  private final double everyS;
  private final Map<Object, Double> takenS = new HashMap<>();

  /** Sets the minimum time between two accepted items [s]; 0 accepts all. */
  Spacing(double everyS) {
    this.everyS = everyS;
  }

  /** Whether to accept a message at this time [s]; each source of a topic is counted separately. */
  boolean takes(Topic topic, U2SAData message, double timeS) {
    String source = Channels.namedOrNew(topic.channel()).sourceOf(message);
    return takes(List.of(topic, source), timeS);
  }

  /** Whether to accept an item of this kind at this time [s]. */
  boolean takes(Object kind, double timeS) {
    Double last = takenS.get(kind);
    if (last != null && timeS < last + everyS - ROUNDING_S) {
      return false;
    }
    takenS.put(kind, timeS);
    return true;
  }
}
