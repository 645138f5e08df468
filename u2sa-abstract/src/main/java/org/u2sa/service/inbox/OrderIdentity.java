package org.u2sa.service.inbox;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.UUID;
import org.u2sa.messages.schema.U2SAData;

/**
 * What identifies an order that a broker may deliver twice (QoS 1): its ID, timestamp and content.
 * With another timestamp an order was given again, and is another one.
 */
final class OrderIdentity {
  private OrderIdentity() {}

  /** As long for a long order as for a short one; empty if it has neither ID nor timestamp. */
  static Optional<String> of(String requestId, U2SAData order) {
    if (requestId.isEmpty() && order.timestamp().isEmpty()) {
      return Optional.empty(); // nobody can tell a repeat from an order given again
    }
    byte[] id = (requestId + "\0").getBytes(StandardCharsets.UTF_8);
    byte[] content = order.serialize();
    byte[] all = new byte[id.length + content.length];
    System.arraycopy(id, 0, all, 0, id.length);
    System.arraycopy(content, 0, all, id.length, content.length);
    return Optional.of(order.type().name() + " " + UUID.nameUUIDFromBytes(all));
  }
}
