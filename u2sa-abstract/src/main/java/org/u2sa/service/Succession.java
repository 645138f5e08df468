package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;

/** What a service knows of the one that takes its place. */
final class Succession {
  private final AtomicReference<ServiceSwap> ordered = new AtomicReference<>();
  private final RetainedMessages retained = new RetainedMessages();
  private volatile U2SAService successor; // written on the service's thread

  /** Takes note of an order. Returns false if there is one already. */
  boolean order(ServiceSwap swap) {
    return ordered.compareAndSet(null, swap);
  }

  /** Forgets an order that came to nothing. */
  void forget(ServiceSwap swap) {
    ordered.compareAndSet(swap, null);
  }

  /**
   * Carries an order out, if there is one; to be called on the service's thread between two
   * messages.
   *
   * @return whether another service has taken the place
   */
  boolean carryOut() {
    ServiceSwap swap = ordered.get();
    return swap != null && swap.carryOut();
  }

  /** Refuses an order that can no longer be carried out. */
  void serviceEnds() {
    ServiceSwap swap = ordered.get();
    if (swap != null) {
      swap.refuse("it ended before");
    }
  }

  void note(ServiceInbox.Delivery delivery) {
    retained.note(delivery);
  }

  RetainedMessages retained() {
    return retained;
  }

  /** The place is the successor's from now on. */
  void succeeded(U2SAService by) {
    successor = by;
  }

  /** Who has taken the place. */
  Optional<U2SAService> successor() {
    return Optional.ofNullable(successor);
  }
}
