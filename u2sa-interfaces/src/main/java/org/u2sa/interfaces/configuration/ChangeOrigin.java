package org.u2sa.interfaces.configuration;

import org.u2sa.interfaces.time.SystemClock;

/**
 * Author and time of a configuration change, for the audit log.
 *
 * @param micros time of the run's clock [µs]
 * @param service service that makes the change; empty if none
 * @param author requester; empty if unknown
 */
public record ChangeOrigin(long micros, String service, String author) {
  static ChangeOrigin here() {
    return new ChangeOrigin(new SystemClock().micros(), "", "");
  }
}
