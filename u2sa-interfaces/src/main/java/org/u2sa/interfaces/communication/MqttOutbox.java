package org.u2sa.interfaces.communication;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;

/**
 * What goes to a broker. Who puts something in sends it too, without waiting; what the network does
 * not take stays for later. Not safe for several threads by itself.
 */
final class MqttOutbox {
  private static final int FIRST_BUFFER = 1 << 14;
  private static final int WAITING_AT_MOST = 4 << 20;

  private final WritableByteChannel channel;
  private ByteBuffer waiting = ByteBuffer.allocateDirect(FIRST_BUFFER); // to be filled further

  /**
   * @param channel one that never blocks
   */
  MqttOutbox(WritableByteChannel channel) {
    this.channel = channel;
  }

  /** Whether the network has taken everything. */
  boolean isEmpty() {
    return waiting.position() == 0;
  }

  /** Room for so many more bytes; null if too much waits. */
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

  /** Sends what the network takes. An interrupt of the thread closes no channel. */
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
