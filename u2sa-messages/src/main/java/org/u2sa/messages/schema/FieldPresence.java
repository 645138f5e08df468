package org.u2sa.messages.schema;

/** Whether a field may be missing. */
enum FieldPresence {
  /** Absent is absent: never 0, never NaN. */
  OPTIONAL,
  /** No message is published or decoded without it. */
  REQUIRED,
  /** Has a value from the start; always written. */
  DEFAULTED
}
