package org.u2sa.service;

import org.u2sa.interfaces.log.LogFile;
import org.u2sa.interfaces.time.Clock;

/** A constructed service, as its recorder and its successor's context see it. */
public interface ServiceInstance {
  /** Service name, as seen by discovery. */
  String getServiceName();

  /** Role of the service. */
  ServiceRole role();

  /** Ends the service. Safe to call twice and from any thread. */
  void kill();

  /**
   * The service's log file, shared with a successor.
   *
   * @param successors the successor's clock
   */
  LogFile logForSuccessor(Clock successors);
}
