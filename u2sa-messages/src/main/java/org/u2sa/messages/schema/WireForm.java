package org.u2sa.messages.schema;

/** How a message is written. Readers take either form, pair by pair. */
public enum WireForm {
  /** Fields by their names, as text, and lists as arrays: any CBOR tool shows what is meant. */
  READABLE {
    @Override
    FieldKey key(String name) {
      return FieldKey.ofName(name);
    }
  },
  /**
   * Fields by their labels, numbers of one to three bytes, where they have any, and lists of
   * numbers and points as {@link TypedArrays}: for links on which bytes are dear. Readers before
   * format 3 refuse it.
   */
  COMPACT {
    @Override
    FieldKey key(String name) {
      Integer label = FieldLabels.of(name);
      return label == null ? FieldKey.ofName(name) : FieldKey.ofLabel(label);
    }
  };

  /** The field's key in this form. */
  abstract FieldKey key(String name);
}
