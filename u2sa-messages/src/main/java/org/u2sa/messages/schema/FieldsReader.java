package org.u2sa.messages.schema;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;

/**
 * Reads the pairs of one map into a message: fast as long as they come as our writers put them,
 * right in any order and form that CBOR allows.
 */
final class FieldsReader {
  private final CborReader reader;
  private final CborInput in;
  private final U2SAData message;
  private final FieldTable<U2SAData> table;
  private final Map<String, Object> unknown; // null: what the message cannot hold is skipped
  private final long pairs;
  private long read; // pairs
  private int next; // index of the field after the one before
  private boolean isInOrder = true; // so far, and so no field can be there twice
  private Set<String> others; // keys without a value in the message; null: none

  /**
   * @param read pairs of the map that were read before
   */
  FieldsReader(
      CborReader reader,
      CborInput in,
      U2SAData message,
      Map<String, Object> unknown,
      long pairs,
      long read) {
    this.reader = reader;
    this.in = in;
    this.message = message;
    this.unknown = unknown;
    this.pairs = pairs;
    this.read = read;
    table = message.ownType().table(in.isLabelNext() ? KeyForm.LABELS : KeyForm.NAMES);
  }

  void readAll() throws MalformedMessageException {
    while (!in.isDone(pairs, read)) {
      int index = table.find(in, next);
      if (index == table.size()) {
        isInOrder = false;
        String name = reader.key();
        field(message.ownType().fieldOrNull(name), name);
        read++;
      } else if (!(table.at(index) instanceof NumberField<U2SAData> number && numbers(number))) {
        MessageField<U2SAData> field = table.at(index);
        in.passTo(in.offset() + table.keyBytes(index));
        next = index + 1;
        field(field, field.name());
        read++;
      }
    }
  }

  /** Reads that number and those that follow; false if it is not as writers write it. */
  private boolean numbers(NumberField<U2SAData> first) {
    long left = pairs == CborInput.UNTIL_BREAK ? Long.SIZE : pairs - read;
    long slots = table.readNumbers(in, message.storage(), first, left);
    if (slots == 0L) {
      return false;
    }
    read += Long.bitCount(slots);
    int last = table.indexOfLast(slots);
    next = last + 1;
    reader.reading(table.at(last).name()); // where errors of what follows are
    return true;
  }

  /** Reads the value after a key. */
  private void field(MessageField<U2SAData> field, String name) throws MalformedMessageException {
    reader.reading(name);
    boolean isKnownTwice = !isInOrder && field != null && field.isSet(message);
    if (isKnownTwice || others != null && others.contains(name)) {
      throw reader.malformed("the key comes twice");
    }
    if (field == null) {
      reader.other(name, unknown);
    } else if (field.read(reader, message)) {
      return;
    }
    if (others == null) {
      others = new HashSet<>();
    }
    others.add(name);
  }
}
