package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.cbor.WireForm;

/**
 * The fields of a type in wire order with their keys of one form, as parallel arrays so that
 * writers and readers need not query each field for constant properties. Thread-safe.
 *
 * @param <T> the message class
 */
final class FieldTable<T extends StoredMessage> {
  /** Key of the type chain in the map of a nested message. */
  static final String TYPE_KEY = "type";

  private static final int MIN_BYTES = 32;
  private static final int MAX_BYTES = 4096; // one large message must not inflate all later buffers

  private final MessageField<T>[] fields;
  final String[] names; // names of the fields
  private final FieldKey[] keys; // keys of the fields
  private final NumberRun[] runs; // run of each number by index; null for other kinds
  private final long defaultedNumbers; // bit n: the number of slot n has a default
  private final long requiredNumbers; // likewise
  private final ValueField<T, ?>[] values; // fields other than numbers
  private final FieldKey[] valueKeys; // keys of values
  private final int[] valueIndexes; // indexes of values in the fields
  private final NumberRun[] runsBefore; // by index in values, plus one after the last; null if none
  private final long defaultedValues; // bit n: the value of slot n has a default
  private final long requiredValues; // likewise
  private int typicalBytes = MIN_BYTES; // of the last message: an estimate, so no lock

  FieldTable(List<MessageField<T>> all, WireForm form) {
    fields = fieldArray(all);
    names = all.stream().map(MessageField::name).toArray(String[]::new);
    keys = Stream.of(names).map(form::key).toArray(FieldKey[]::new);
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

  /** Run of the numbers between two indexes, the second exclusive; null if empty. */
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

  @SuppressWarnings({"unchecked", "rawtypes"}) // generic arrays cannot be created
  private static <T extends StoredMessage> MessageField<T>[] fieldArray(
      List<MessageField<T>> fields) {
    return fields.toArray(new MessageField[0]);
  }

  @SuppressWarnings({"unchecked", "rawtypes"}) // likewise
  private static <T extends StoredMessage> ValueField<T, ?>[] valueArray(
      List<ValueField<T, ?>> values) {
    return values.toArray(new ValueField[0]);
  }

  /** A missing required field; null if none is missing. */
  MessageField<T> missing(T message) {
    FieldStorage storage = message.storage;
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

  /** Number of fields of a message on the wire. */
  int count(T message) {
    FieldStorage storage = message.storage;
    return Long.bitCount(storage.numbersSet() | defaultedNumbers)
        + Long.bitCount(storage.valuesSet() | defaultedValues)
        + (storage.hasTimestamp() ? 1 : 0);
  }

  int typicalBytes() {
    return typicalBytes;
  }

  void typicalBytes(int bytes) {
    typicalBytes = Math.max(MIN_BYTES, Math.min(bytes, MAX_BYTES));
  }

  void write(CborOutput out, T message) {
    FieldStorage storage = message.storage;
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
   * Fast path: reads pairs of a map as long as they are in our writers' form: shortest keys in
   * field order, numbers as {@link NumberRun} expects them.
   *
   * @param pairs number of pairs in the map
   * @param read number of pairs already read
   * @return number of pairs read in total
   */
  long readInOrder(CborReader reader, CborInput in, T message, long pairs, long read)
      throws MalformedMessageException {
    FieldStorage storage = message.storage;
    long done = read;
    for (int i = 0; done < pairs; i++) {
      NumberRun run = runsBefore[i];
      NumberPattern numbers = run == null ? null : run.read(in, storage, pairs, pairs - done);
      if (numbers != null) {
        done += numbers.count();
        reader.reading(run.start + numbers.last); // position for errors in what follows
      }
      if (i == values.length) {
        return done;
      }
      if (done < pairs && in.isNext(valueKeys[i])) {
        int start = in.offset();
        in.passTo(start + valueKeys[i].length());
        reader.reading(valueIndexes[i]);
        if (!values[i].read(reader, message)) {
          in.passTo(start); // so that keys without a value are recorded
          return done;
        }
        done++;
      }
    }
    return done;
  }

  /**
   * Peeks which field's key comes next, in its shortest form.
   *
   * @param from index of the first candidate: the field after the previous one, as writers keep the
   *     order
   * @return the field's index; {@link #size()} if none matches or the field is before {@code from}
   */
  int find(CborInput in, int from) {
    int index = from;
    while (index < keys.length && !in.isNext(keys[index])) {
      index++;
    }
    return index;
  }

  /** Run that the field at this index belongs to; null if it is not a number. */
  NumberRun runAt(int index) {
    return runs[index];
  }

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
