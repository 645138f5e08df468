package org.u2sa.messages.schema;

import java.util.List;

/**
 * Messages to bytes for a transport, and bytes to messages of the registered types. Immutable, safe
 * for all threads.
 */
public final class MessageCodec {
  private final MessageTypes types;
  private final WireForm keys;
  private final RecentTexts texts = new RecentTexts();

  /** A codec that knows the given types and writes fields with their names. */
  public MessageCodec(MessageTypes types) {
    this(types, WireForm.READABLE);
  }

  /**
   * @param types that it reads; it writes any
   * @param keys how it names the fields of what it writes; it reads either form
   */
  public MessageCodec(MessageTypes types, WireForm keys) {
    this.types = types;
    this.keys = keys;
  }

  /** The types that it knows. */
  public MessageTypes types() {
    return types;
  }

  /**
   * As {@link U2SAData#serialize()}, but with fields named as this codec does.
   *
   * @throws IllegalStateException if a required field is missing or the bytes exceed 1 MiB
   */
  public byte[] encode(U2SAData message) {
    return CborWriter.bytes(message, null, keys);
  }

  /**
   * {@link #encode(U2SAData)} with a word about who sends it.
   *
   * @throws IllegalStateException if a required field is missing or the bytes exceed 1 MiB
   */
  public byte[] encode(U2SAData message, Origin sentFrom) {
    return CborWriter.bytes(message, sentFrom, keys);
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
    return CborReader.message(types, typeChain, new CborInput(bytes, texts));
  }
}
