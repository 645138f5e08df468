package org.u2sa.gcs.mavlink;

import java.io.IOException;

/** A link to stations; confined to the bridge's thread. */
interface StationLink extends AutoCloseable {
  /** Reads and handles received bytes, and sends queued ones. */
  void exchange(long nowMicros) throws IOException;

  /** Sessions of the stations that are connected. */
  Iterable<StationSession> sessions();

  @Override
  void close() throws IOException;
}
