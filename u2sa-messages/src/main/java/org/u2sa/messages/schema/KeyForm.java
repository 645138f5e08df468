package org.u2sa.messages.schema;

/** How the fields of a message are named on the wire. Readers take either, pair by pair. */
public enum KeyForm {
  /** By their names, as text: any CBOR tool shows what is meant. */
  NAMES {
    @Override
    FieldKey key(String name) {
      return FieldKey.ofName(name);
    }
  },
  /**
   * By their labels, numbers of one to three bytes, where they have any: for links on which bytes
   * are dear. Readers before format 3 refuse them.
   */
  LABELS {
    @Override
    FieldKey key(String name) {
      Integer label = FieldLabels.of(name);
      return label == null ? FieldKey.ofName(name) : FieldKey.ofLabel(label);
    }
  };

  /** The field's key in this form. */
  abstract FieldKey key(String name);
}
