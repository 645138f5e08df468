package org.u2sa.interfaces.communication;

import org.u2sa.messages.schema.U2SAData;

/**
 * What a service hands the transport to be called. Calls come on the publisher's or the transport's
 * thread, so they must return at once and not throw.
 */
public interface Receiver {
  /** Takes one frozen message. */
  void receive(Channel<?> channel, U2SAData message);

  /**
   * Takes note of trouble on the way, for the log: connection lost or restored, a message that
   * could not be read.
   */
  void trouble(String what);
}
