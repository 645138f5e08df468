package org.u2sa.messages.contract;

/** Condition of a service as seen from outside. Names are part of the wire format; append only. */
public enum Condition {
  /** Running and reporting. */
  ALIVE,
  /** Reports are overdue for an unknown reason. */
  SILENT,
  /** Its thread is alive but a callback does not return. */
  HUNG,
  /** Its thread has ended unannounced. */
  DEAD,
  /** Connection lost: its process, host or network is gone. */
  LOST,
  /** Reporting, but not publishing its data. */
  STALLED,
  /** Ended after errors. */
  FAILED,
  /** Ended as requested. */
  STOPPED,
  /** No longer monitored: earlier conditions are void. */
  UNWATCHED
}
