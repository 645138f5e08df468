package org.u2sa.interfaces.mqtt;

import java.nio.channels.ByteChannel;

/**
 * Bytes from and to the broker, never blocking. One thread at a time reads and one writes; both may
 * do so at once.
 */
interface BrokerChannel extends ByteChannel {
  /** Whether bytes have arrived that a selector does not announce; asked by the reading thread. */
  boolean hasUnread();

  /** Whether the next write has something to send besides its own bytes. */
  boolean hasUnsent();
}
