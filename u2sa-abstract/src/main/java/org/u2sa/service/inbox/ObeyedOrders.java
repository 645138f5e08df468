package org.u2sa.service.inbox;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.schema.U2SAData;

/**
 * The newest orders that were obeyed, for those that would set a vehicle in motion if a broker
 * delivered them twice (QoS 1). With another timestamp an order was given again, and is another
 * one. Not thread-safe.
 */
public final class ObeyedOrders {
  private static final int REMEMBERED = 64;

  private final Set<String> identities = new LinkedHashSet<>(); // the oldest first

  /**
   * Remembers an order.
   *
   * @return whether it is new; always for one without ID and timestamp, which nobody can recognise
   */
  public boolean add(String requestId, U2SAData order) {
    Optional<String> identity = OrderIdentity.of(requestId, order);
    if (identity.isEmpty()) {
      return true;
    }
    boolean isNew = identities.add(identity.get());
    if (identities.size() > REMEMBERED) {
      identities.remove(identities.iterator().next());
    }
    return isNew;
  }

  /** For a successor, the oldest first. */
  public List<String> identities() {
    return new ArrayList<>(identities);
  }

  /** Remembers what a predecessor obeyed. */
  public void takeOver(List<String> predecessors) {
    identities.addAll(predecessors);
  }
}
