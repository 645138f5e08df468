package org.u2sa.messages.schema;

/** Whether a field may be missing. */
enum FieldPresence {
  /** May be absent; absence is not encoded as 0 or NaN. */
  OPTIONAL,
  /** Required for publishing and decoding. */
  REQUIRED,
  /** Has a default; always written. */
  DEFAULTED
}
