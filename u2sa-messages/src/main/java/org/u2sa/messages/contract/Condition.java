package org.u2sa.messages.contract;

/** How a service looks from outside. The names travel; append only. */
public enum Condition {
  /** It reports, and runs. */
  ALIVE,
  /** Its reports are overdue, and nothing says why. */
  SILENT,
  /** Its thread lives, but its code does not return. */
  HUNG,
  /** Its thread has ended without a word. */
  DEAD,
  /** Its connection broke: its process or host is gone, or the network is. */
  LOST,
  /** It reports, but the data that it is there for do not come. */
  STALLED,
  /** It ended itself after errors. */
  FAILED,
  /** It ended as it was told. */
  STOPPED,
  /** Nobody watches it any more: what was said of it before does not count. */
  UNWATCHED
}
