package org.u2sa.gcs.mavlink;

import java.io.IOException;

/** Reads all that stations have sent, so that nothing of it waits in a link's buffer. */
final class StationReader {
  private static final int CHUNK = 4096;
  private static final int CHUNKS_PER_TURN = 64;
  private static final int HANDLED_PER_TURN = 4; // others have their turn, too

  /** Received bytes of one station. */
  @FunctionalInterface
  interface Source {
    /** Reads what has arrived; 0: nothing, negative: the end. */
    int read(byte[] buffer) throws IOException;
  }

  private final byte[] buffer = new byte[CHUNK];

  /** Passes on what has arrived; false at its end. */
  boolean read(Source source, StationSession session, long nowMicros) throws IOException {
    int handled = 0;
    for (int i = 0; i < CHUNKS_PER_TURN && handled < HANDLED_PER_TURN; i++) {
      int length = source.read(buffer);
      if (length <= 0) {
        return length == 0;
      }
      session.receive(buffer, length, nowMicros);
      handled += session.isOpen(nowMicros) ? 1 : 0;
    }
    return true;
  }
}
