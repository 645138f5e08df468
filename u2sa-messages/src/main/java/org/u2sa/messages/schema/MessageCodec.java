package org.u2sa.messages.schema;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.RecentTexts;
import org.u2sa.messages.cbor.TextPeek;
import org.u2sa.messages.cbor.WireForm;

/** Encodes messages and decodes messages of the registered types. Immutable and thread-safe. */
public final class MessageCodec {
  private final MessageTypes types;
  private final WireForm keys;
  private final RecentTexts texts = new RecentTexts();

  /** Creates a codec for the given types that writes fields with their names. */
  public MessageCodec(MessageTypes types) {
    this(types, WireForm.READABLE);
  }

  /**
   * @param types types to decode; any type can be encoded
   * @param keys form of field keys when encoding; either form is decoded
   */
  public MessageCodec(MessageTypes types, WireForm keys) {
    this.types = types;
    this.keys = keys;
  }

  /** The known types. */
  public MessageTypes types() {
    return types;
  }

  /**
   * Like {@link U2SAData#serialize()}, but with this codec's form of field keys.
   *
   * @throws IllegalStateException if a required field is missing or the bytes exceed 1 MiB
   */
  public byte[] encode(U2SAData message) {
    return message.bytes(null, keys);
  }

  /**
   * Like {@link #encode(U2SAData)}, with the sender's origin.
   *
   * @throws IllegalStateException if a required field is missing or the bytes exceed 1 MiB
   */
  public byte[] encode(U2SAData message, Origin sentFrom) {
    return message.bytes(sentFrom, keys);
  }

  /**
   * Decodes a message. Unknown keys are skipped; an unregistered type is decoded as its nearest
   * registered ancestor, or as an {@link OpaqueMessage}, and keeps its additional fields for {@link
   * U2SAData#enumerateFields()}.
   *
   * @param typeChain from the topic, see {@link MessageType#chain()}
   * @throws MalformedMessageException for any malformed chain or bytes; no other exception is
   *     thrown
   */
  public U2SAData decode(List<String> typeChain, byte[] bytes) throws MalformedMessageException {
    if (bytes.length > Limits.PAYLOAD_BYTES) {
      throw new MalformedMessageException(
          "payload",
          Limits.PAYLOAD_BYTES,
          "expected at most " + Limits.PAYLOAD_BYTES + " bytes, not " + bytes.length);
    }
    return CborMessageReader.message(types, typeChain, new CborInput(bytes, texts));
  }

  /**
   * Reads one text of an encoded message without decoding the rest, such as the name of its source.
   *
   * @param field name of the field
   * @return empty if the field is absent, or readers reject the message before they get there
   */
  public Optional<String> peek(byte[] bytes, String field) {
    return TextPeek.of(new CborInput(bytes, texts), field);
  }
}
