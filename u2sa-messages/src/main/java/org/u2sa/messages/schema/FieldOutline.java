package org.u2sa.messages.schema;

/** Properties common to all kinds of fields, passed by the schema. */
record FieldOutline(
    String owner, String name, String unit, Presence presence, int slot, int bit, int since) {
  static final int NO_BIT = -1;

  enum Presence {
    /** May be absent; absence is not encoded as 0 or NaN. */
    OPTIONAL,
    /** Required for publishing and decoding. */
    REQUIRED,
    /** Has a default; always written. */
    DEFAULTED
  }
}
