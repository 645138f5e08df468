package org.u2sa.service;

import org.u2sa.interfaces.log.LogFile;
import org.u2sa.interfaces.time.Clock;

/** A constructed service, as its recorder and its successor's context see it. */
public interface ServiceInstance {
  String getServiceName();

  ServiceRole role();

  /** Ends the service. Safe to call twice and from any thread. */
  void kill();

  /** The log file, shared with a successor that has its own clock. */
  LogFile logForSuccessor(Clock successors);
}
