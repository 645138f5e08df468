package org.u2sa.messages.schema;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.Limits;
import org.u2sa.messages.cbor.MalformedMessageException;

/**
 * Reads the pairs of one map into a message in any order and form that CBOR allows; pairs in our
 * writers' form have already been read by {@link FieldTable#readInOrder}.
 *
 * @param <T> the message's class
 */
final class FieldsReader<T extends U2SAData> {
  private final CborReader reader;
  private final CborInput in;
  private final T message;
  private final MessageType<T> type;
  private final FieldTable<T> table;
  private final Map<String, Object> unknown; // null: unknown fields are skipped
  private int next; // index after the previous field
  private NumberRun run; // run being read; null if none
  private long opening; // fingerprint of the map at the start of the run
  private Set<String> others; // keys without a value in the message; null if none

  FieldsReader(
      CborReader reader,
      T message,
      MessageType<T> type,
      FieldTable<T> table,
      Map<String, Object> unknown) {
    this.reader = reader;
    in = reader.in;
    this.message = message;
    this.type = type;
    this.table = table;
    this.unknown = unknown;
  }

  void readRest(long pairs, long read) throws MalformedMessageException {
    for (long done = read; !in.isDone(pairs, done); done++) {
      int index = table.find(in, next);
      enter(index == table.size() ? null : table.runAt(index), pairs);
      if (index == table.size()) {
        String name = reader.key();
        reader.reading(name);
        field(type.fieldOrNull(name), name);
      } else {
        MessageField<T> field = table.at(index);
        in.passTo(in.offset() + table.keyBytes(index));
        next = index + 1;
        reader.reading(index);
        field(field, field.name());
      }
    }
    enter(null, pairs);
  }

  /** At the end of an unexpected run of numbers, lets the run remember the pattern. */
  private void enter(NumberRun following, long pairs) {
    if (following == run) {
      return;
    }
    if (run != null) {
      run.expect(opening, message.storage);
    }
    run = following;
    opening = NumberRun.opening(in, pairs);
  }

  private void field(MessageField<T> field, String name) throws MalformedMessageException {
    boolean isKnownTwice = field != null && field.isSet(message);
    if (isKnownTwice || others != null && others.contains(name)) {
      throw reader.malformed("the key occurs twice");
    }
    if (field == null) {
      other(name);
    } else if (field.read(reader, message)) {
      return;
    }
    if (others == null) {
      others = new HashSet<>();
    }
    others.add(name);
  }

  private void other(String name) throws MalformedMessageException {
    if (reader.depth == 1 && name.equals(Origin.KEY)) {
      reader.readOrigin();
    } else if (unknown != null && !name.equals(FieldTable.TYPE_KEY)) {
      unknown.put(name, AnyValue.read(reader));
    } else {
      in.skip(Limits.DEPTH - reader.depth);
    }
  }
}
