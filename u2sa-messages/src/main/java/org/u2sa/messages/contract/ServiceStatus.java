package org.u2sa.messages.contract;

/** Life-cycle status of a service. Names are part of the wire format; append only. */
public enum ServiceStatus {
  /** Constructed but not started. */
  CREATED,
  /** Running. */
  RUNNING,
  /** Stopping as requested. */
  STOPPING,
  /** Ended as requested. */
  STOPPED,
  /** Ended after errors. */
  FAILED
}
