package org.u2sa.messages.cbor;

import java.util.Optional;

/**
 * Reads one text of an encoded message without decoding the rest. Because readers reject messages
 * with duplicate keys or malformed remainders, no reader gets a different text.
 */
public final class TextPeek {
  private TextPeek() {}

  /**
   * The text of a field of the outermost map, in either wire form; empty if it is absent, not a
   * text, or preceded by malformed bytes: readers then reject the message or use the field's
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
    } catch (RuntimeException e) { // thrown by CborInput for malformed bytes
      return Optional.empty();
    }
  }
}
