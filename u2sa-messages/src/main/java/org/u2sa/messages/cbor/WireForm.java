package org.u2sa.messages.cbor;

/** Form of an encoded message. Readers accept either form, for each pair. */
public enum WireForm {
  /** Text names as keys and plain arrays as lists: readable with any CBOR tool. */
  READABLE,

  /**
   * Labels of one to three bytes as keys, where defined, and lists of numbers and points as {@link
   * TypedArrays}: for low-bandwidth links. Readers before format 3 reject it.
   */
  COMPACT;

  /** The field's key in this form. */
  public FieldKey key(String name) {
    Integer label = this == COMPACT ? FieldLabels.of(name) : null;
    return label == null ? FieldKey.ofName(name) : FieldKey.ofLabel(label);
  }
}
