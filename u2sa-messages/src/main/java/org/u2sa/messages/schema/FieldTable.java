package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.List;

/**
 * The fields of a type in the order of the wire with their keys of one form, laid out so that
 * writers and readers pass over them without asking each for what never changes. Safe for all
 * threads.
 *
 * @param <T> the message class
 */
final class FieldTable<T extends U2SAData> {
  private static final int LEAST_BYTES = 32;
  private static final int MOST_BYTES =
      4096; // a single large message must not make all others dear

  private final MessageField<T>[] fields;
  private final FieldKey[] keys; // of them
  private final NumberRun[] runs; // by index: that of a number; null for other kinds
  private final long defaultedNumbers; // bit n: the number of slot n has a default
  private final long requiredNumbers; // likewise
  private final ValueField<T, ?>[] values; // of the fields
  private final FieldKey[] valueKeys; // of them
  private final int[] valueIndexes; // which of the fields they are
  private final NumberRun[] runsBefore; // by index in values, and behind the last; null: none
  private final long defaultedValues; // bit n: the value of slot n has a default
  private final long requiredValues; // likewise
  private int typicalBytes = LEAST_BYTES; // of the last message written: a guess, so no lock

  FieldTable(List<MessageField<T>> all, WireForm form) {
    fields = fieldArray(all);
    keys = all.stream().map(field -> form.key(field.name())).toArray(FieldKey[]::new);
    runs = new NumberRun[fields.length];
    List<ValueField<T, ?>> valueList = new ArrayList<>();
    List<FieldKey> valueKeyList = new ArrayList<>();
    int[] indexes = new int[fields.length];
    List<NumberRun> before = new ArrayList<>();
    long needed = 0L;
    long neededValues = 0L;
    long defaulted = 0L;
    long defaultedValue = 0L;
    int runStart = 0;
    for (int index = 0; index < fields.length; index++) {
      MessageField<T> field = fields[index];
      long bit = 1L << field.slot;
      if (field instanceof NumberField<T> number) {
        defaulted |= Double.isNaN(number.ifUnset) ? 0L : bit;
        needed |= number.isRequired() ? bit : 0L;
      } else if (field instanceof ValueField<T, ?> value) {
        before.add(run(runStart, index));
        runStart = index + 1;
        indexes[valueList.size()] = index;
        valueList.add(value);
        valueKeyList.add(keys[index]);
        defaultedValue |= value.ifUnset == null ? 0L : bit;
        neededValues |= value.isRequired() ? bit : 0L;
      }
    }
    before.add(run(runStart, fields.length));
    runsBefore = before.toArray(new NumberRun[0]);
    defaultedNumbers = defaulted;
    requiredNumbers = needed;
    values = valueArray(valueList);
    valueIndexes = indexes;
    valueKeys = valueKeyList.toArray(new FieldKey[0]);
    defaultedValues = defaultedValue;
    requiredValues = neededValues;
  }

  /** The numbers from one index to before another; null if there are none. */
  private NumberRun run(int start, int end) {
    if (start == end) {
      return null;
    }
    List<NumberField<?>> numbers = new ArrayList<>();
    for (int index = start; index < end; index++) {
      numbers.add((NumberField<?>) fields[index]);
    }
    NumberRun run = new NumberRun(start, numbers, List.of(keys).subList(start, end));
    for (int index = start; index < end; index++) {
      runs[index] = run;
    }
    return run;
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // there are no arrays of generic types
  private static <T extends U2SAData> MessageField<T>[] fieldArray(List<MessageField<T>> fields) {
    return fields.toArray(new MessageField[0]);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // likewise
  private static <T extends U2SAData> ValueField<T, ?>[] valueArray(List<ValueField<T, ?>> values) {
    return values.toArray(new ValueField[0]);
  }

  /** A required field that the message does not have; null if it has all. */
  MessageField<T> missing(T message) {
    FieldStorage storage = message.storage();
    boolean isComplete =
        (storage.numbersSet() & requiredNumbers) == requiredNumbers
            && (storage.valuesSet() & requiredValues) == requiredValues;
    return isComplete ? null : firstMissing(message);
  }

  private MessageField<T> firstMissing(T message) {
    for (MessageField<T> field : fields) {
      if (field.isRequired() && !field.isSet(message)) {
        return field;
      }
    }
    return null;
  }

  /** How many fields of a message are on the wire. */
  int count(T message) {
    FieldStorage storage = message.storage();
    return Long.bitCount(storage.numbersSet() | defaultedNumbers)
        + Long.bitCount(storage.valuesSet() | defaultedValues)
        + (storage.hasTimestamp() ? 1 : 0);
  }

  /** About as many bytes as the last message took. */
  int typicalBytes() {
    return typicalBytes;
  }

  /** Remembers how many bytes a message took. */
  void typicalBytes(int bytes) {
    typicalBytes = Math.max(LEAST_BYTES, Math.min(bytes, MOST_BYTES));
  }

  /** Writes all fields of a message that are to be written, in their order. */
  void write(CborOutput out, T message) {
    FieldStorage storage = message.storage();
    for (int i = 0; i < values.length; i++) {
      if (runsBefore[i] != null) {
        runsBefore[i].write(out, storage);
      }
      values[i].write(out, valueKeys[i], message);
    }
    if (runsBefore[values.length] != null) {
      runsBefore[values.length].write(out, storage);
    }
  }

  /**
   * Reads pairs of a map as long as they come as our writers put them: each key in its shortest
   * form and in the order of the fields, numbers as {@link NumberRun} expects them.
   *
   * @param pairs of the map
   * @param read how many of them were read before
   * @return how many have been read then
   */
  long readInOrder(CborReader reader, CborInput in, T message, long pairs, long read)
      throws MalformedMessageException {
    FieldStorage storage = message.storage();
    long done = read;
    for (int i = 0; done < pairs; i++) {
      NumberRun run = runsBefore[i];
      NumberPattern numbers = run == null ? null : run.read(in, storage, pairs, pairs - done);
      if (numbers != null) {
        done += numbers.count();
        reader.reading(run.start() + numbers.last()); // where errors of what follows are
      }
      if (i == values.length) {
        return done;
      }
      if (done < pairs && in.isNext(valueKeys[i])) {
        int start = in.offset();
        in.passTo(start + valueKeys[i].length());
        reader.reading(valueIndexes[i]);
        if (!values[i].read(reader, message)) {
          in.passTo(start); // for who remembers the keys that have no value
          return done;
        }
        done++;
      }
    }
    return done;
  }

  /**
   * Which field's key comes next, written as short as can be; it stays there.
   *
   * @param from index of the field to begin with: that after the one before, as writers keep the
   *     order
   * @return the field's index; {@link #size()} if it is none of those, or is before that one
   */
  int find(CborInput in, int from) {
    int index = from;
    while (index < keys.length && !in.isNext(keys[index])) {
      index++;
    }
    return index;
  }

  /** The numbers that the field at that index is one of; null if it is of another kind. */
  NumberRun runAt(int index) {
    return runs[index];
  }

  /** How many bytes the key of a field takes. */
  int keyBytes(int index) {
    return keys[index].length();
  }

  MessageField<T> at(int index) {
    return fields[index];
  }

  int size() {
    return fields.length;
  }
}
