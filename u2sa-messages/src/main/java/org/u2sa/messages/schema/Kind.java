package org.u2sa.messages.schema;

import org.u2sa.messages.cbor.ByteString;

/** Kind of a field's value, which determines its form on the wire and in XML. */
public enum Kind {
  /** A finite double. CBOR float64. */
  DOUBLE("float64"),
  /** A long. CBOR integer. */
  LONG("int"),
  /** True or false. CBOR bool. */
  BOOLEAN("bool"),
  /** Text of at most 64 KiB in UTF-8. CBOR text. */
  STRING("text"),
  /** A {@link ByteString} of at most 960 KiB. CBOR byte string; base64 in XML and JSON. */
  BYTES("byte string"),
  /** A list of texts. CBOR array of text. */
  STRING_LIST("array of text"),
  /** A list of finite doubles. CBOR array of float64. */
  DOUBLE_LIST("array of float64"),
  /** A list of booleans. CBOR array of bool. */
  BOOLEAN_LIST("array of bool"),
  /** One of an enum's constants. CBOR text, the constant's name. */
  ENUM("text (enum)"),
  /** A {@link org.u2sa.messages.frame.ReferenceFrame}. CBOR text, its name. */
  FRAME("text (frame)"),
  /** A {@link org.u2sa.messages.frame.Point}. CBOR array of three float64. */
  POINT("array of 3 float64"),
  /** A list of points. CBOR array of arrays. */
  POINT_LIST("array of points"),
  /** A list of messages. CBOR array of maps, each opening with its "type" chain. */
  MESSAGE_LIST("array of messages");

  private final String cborType;

  Kind(String cborType) {
    this.cborType = cborType;
  }

  /** The type on the wire, in the words of docs/wire-protocol.md. */
  public String cborType() {
    return cborType;
  }
}
