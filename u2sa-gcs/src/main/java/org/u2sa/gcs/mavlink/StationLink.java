package org.u2sa.gcs.mavlink;

import java.io.IOException;

/** A way to stations; confined to the bridge's thread. */
interface StationLink extends AutoCloseable {
  /** Reads and handles what has arrived, and sends what waits. */
  void exchange(long nowMicros) throws IOException;

  /** Sessions of the stations that are connected. */
  Iterable<StationSession> sessions();

  @Override
  void close() throws IOException;
}
