package org.u2sa.messages.schema;

import java.util.List;

/**
 * Reads messages of the registered types from bytes. Immutable, safe for all threads. Writing is
 * {@link U2SAData#serialize()}.
 */
public final class MessageCodec {
  private final MessageTypes types;

  /** A codec that knows the given types. */
  public MessageCodec(MessageTypes types) {
    this.types = types;
  }

  /** The types that it knows. */
  public MessageTypes types() {
    return types;
  }

  /**
   * The message in the bytes. Unknown keys are skipped; a type that is not registered is read as
   * its nearest registered ancestor, or as an {@link OpaqueMessage}, and keeps what it has beyond
   * that one for {@link U2SAData#enumerateFields()}.
   *
   * @param typeChain from the topic, see {@link MessageType#chain()}
   * @throws MalformedMessageException for whatever is wrong with chain or bytes; no other exception
   *     is thrown for them
   */
  public U2SAData decode(List<String> typeChain, byte[] bytes) throws MalformedMessageException {
    if (bytes.length > Limits.PAYLOAD_BYTES) {
      throw new MalformedMessageException(
          "payload",
          Limits.PAYLOAD_BYTES,
          "expected at most " + Limits.PAYLOAD_BYTES + " bytes, not " + bytes.length);
    }
    return CborReader.message(types, typeChain, bytes);
  }
}
