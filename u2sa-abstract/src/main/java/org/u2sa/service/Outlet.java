package org.u2sa.service;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.U2SAData;

/** Where a service's messages go. */
@FunctionalInterface
public interface Outlet {
  /**
   * Publishes a frozen message. Returns whether it was accepted.
   *
   * @throws org.u2sa.interfaces.communication.CommunicationException if the service is not
   *     connected
   */
  boolean publish(Channel<?> channel, U2SAData message);
}
