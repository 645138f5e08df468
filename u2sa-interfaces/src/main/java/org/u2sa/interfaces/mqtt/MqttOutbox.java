package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * Output buffer of a broker connection. The writer also sends, without blocking; the rest is kept
 * for later. Not thread-safe.
 */
final class MqttOutbox {
  private static final int FIRST_BUFFER = 1 << 14;
  private static final int WAITING_AT_MOST = 4 << 20;

  private final BrokerChannel channel;
  private ByteBuffer waiting = ByteBuffer.allocateDirect(FIRST_BUFFER); // in write mode

  MqttOutbox(BrokerChannel channel) {
    this.channel = channel;
  }

  boolean isEmpty() {
    return waiting.position() == 0 && !channel.hasUnsent();
  }

  /** Buffer with room for this many bytes; null if too much is pending. */
  ByteBuffer room(int bytes) {
    if (bytes > waiting.remaining()) {
      int needed = waiting.position() + bytes;
      if (needed > WAITING_AT_MOST) {
        return null;
      }
      ByteBuffer larger =
          ByteBuffer.allocateDirect(Math.min(WAITING_AT_MOST, Math.max(needed, 2 * needed)));
      MqttPackets.flip(waiting);
      larger.put(waiting);
      waiting = larger;
    }
    return waiting;
  }

  /** Sends as much as the network accepts. A thread interrupt does not close the channel. */
  void send() throws IOException {
    if (isEmpty()) {
      return;
    }
    boolean interrupted = Thread.interrupted();
    try {
      MqttPackets.flip(waiting);
      channel.write(waiting);
    } finally {
      waiting.compact();
      if (interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
