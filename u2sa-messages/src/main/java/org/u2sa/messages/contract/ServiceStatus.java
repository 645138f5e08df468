package org.u2sa.messages.contract;

/** Where a service is in its life. The names travel; append only. */
public enum ServiceStatus {
  /** Constructed, not started. */
  CREATED,
  /** Running. */
  RUNNING,
  /** Told to stop, not there yet. */
  STOPPING,
  /** Ended as told. */
  STOPPED,
  /** Ended by itself after errors. */
  FAILED
}
