package org.u2sa.drivers.link;

import java.nio.file.Path;
import org.u2sa.interfaces.time.Clock;

/** Records links in tests of other packages. */
public final class Recordings {
  private Recordings() {}

  /** The link, recorded in the file. */
  public static ByteLink record(ByteLink link, Path file, Clock clock) {
    return new RecordingLink(link, file, clock);
  }
}
