package org.u2sa.interfaces.configuration;

import org.u2sa.interfaces.time.SystemClock;

/**
 * Who changes a configuration and when, for its audit log.
 *
 * @param micros time of the run's clock [µs]
 * @param service the service through which it is changed; empty if none
 * @param author who asks for it; empty if unknown
 */
public record ChangeOrigin(long micros, String service, String author) {
  /** A change by this program itself, now. */
  static ChangeOrigin here() {
    return new ChangeOrigin(new SystemClock().micros(), "", "");
  }
}
