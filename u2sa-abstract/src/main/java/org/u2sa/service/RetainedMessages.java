package org.u2sa.service;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The messages that a service handled last on retained channels: what a successor would be handed
 * if it subscribed anew, without a word with the Communication Manager. Where each message matters,
 * several are kept, since the last one may mean nothing alone, as an order to clear an older stop.
 * Belongs to the service's thread.
 */
final class RetainedMessages {
  private static final int KEPT_OF_EVERY = 64;

  private final Map<String, Map<String, Deque<ServiceInbox.Delivery>>> last = new LinkedHashMap<>();

  /** Takes note that a message is being handled. */
  void note(ServiceInbox.Delivery delivery) {
    if (!delivery.channel().isRetained()) {
      return;
    }
    Deque<ServiceInbox.Delivery> ofSource =
        last.computeIfAbsent(delivery.channel().name(), name -> new LinkedHashMap<>())
            .computeIfAbsent(
                delivery.channel().sourceOf(delivery.message()), source -> new ArrayDeque<>());
    ofSource.add(delivery);
    if (ofSource.size() > (delivery.channel().deliversEvery() ? KEPT_OF_EVERY : 1)) {
      ofSource.remove();
    }
  }

  /** All of them, of one source in the order in which they were handled. */
  List<ServiceInbox.Delivery> all() {
    List<ServiceInbox.Delivery> all = new ArrayList<>();
    last.values().forEach(ofChannel -> ofChannel.values().forEach(all::addAll));
    return all;
  }
}
