package org.u2sa.interfaces.communication;

import org.u2sa.messages.schema.U2SAData;

/**
 * Callback of a service for the transport. Called on the publisher's or the transport's thread, so
 * it must return quickly and not throw.
 */
public interface Receiver {
  /** Handles a frozen message. */
  void receive(Channel<?> channel, U2SAData message);

  /** Handles a transport problem, for the log: connection lost or restored, unreadable message. */
  void trouble(String what);
}
