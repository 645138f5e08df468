package org.u2sa.messages.cbor;

import java.util.Optional;

/**
 * Reads one text of an encoded message without decoding the rest. Since readers reject a message
 * that has a key twice, or is malformed behind it, no reader gets another text.
 */
public final class TextPeek {
  private TextPeek() {}

  /**
   * The text of a field of the outermost map, in either wire form; empty if it is absent, is no
   * text, or the bytes before it are malformed: readers then reject the message, or use the field's
   * default.
   */
  public static Optional<String> of(CborInput in, String field) {
    try {
      long pairs = in.map();
      for (long read = 0; !in.isDone(pairs, read); read++) {
        boolean isLabel = (in.next() & Cbor.MAJOR) == Cbor.UNSIGNED;
        String key = isLabel ? FieldLabels.name(in.count()) : FieldLabels.name(in.text());
        if (key.equals(field)) {
          return Optional.of(in.text());
        }
        in.skip(Limits.DEPTH);
      }
      return Optional.empty();
    } catch (RuntimeException e) { // as CborInput throws for malformed bytes
      return Optional.empty();
    }
  }
}
