package org.u2sa.messages.schema;

import java.util.List;
import java.util.Map;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.frame.ReferenceFrame;

/**
 * View of a message for fields, kinds and the writer: its values, but not its type. {@link
 * U2SAData} is the only subclass.
 */
abstract class StoredMessage {
  final FieldStorage storage = new FieldStorage(valueSlots());

  /** Number of slots for values other than numbers. Called while the message is constructed. */
  abstract int valueSlots();

  /** Frame of the message's coordinates, from its frame field; BODY for messages without one. */
  abstract ReferenceFrame frame();

  /** Names from the topmost ancestor to the message's own type, even if unknown to this reader. */
  abstract List<String> typeChain();

  /** Fields of the unknown subclass in placeholders; else empty. */
  abstract Map<String, Object> unknownFields();

  abstract void writeNested(CborOutput out);
}
