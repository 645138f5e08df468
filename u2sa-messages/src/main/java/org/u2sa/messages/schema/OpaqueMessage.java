package org.u2sa.messages.schema;

import java.util.List;

/**
 * A message of an unknown type without a known ancestor. All its fields appear in {@link
 * #enumerateFields()}, and it is re-encoded unchanged.
 */
public final class OpaqueMessage extends U2SAData {
  /** Opaque messages share this schema; their own type's names are in {@link #typeChain()}. */
  public static final MessageType<OpaqueMessage> TYPE =
      Schema.of(OpaqueMessage.class, OpaqueMessage::new, U2SAData.TYPE).build();

  OpaqueMessage() {}

  @Override
  public MessageType<OpaqueMessage> type() {
    return TYPE;
  }

  /** The type's own name, the last of its chain. */
  public String typeName() {
    List<String> chain = typeChain();
    return chain.get(chain.size() - 1);
  }
}
