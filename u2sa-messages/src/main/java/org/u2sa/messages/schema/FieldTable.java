package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.List;

/**
 * The fields of a type in the order of the wire with their keys of one form, laid out so that
 * writers and readers pass over them without asking each for what never changes. Immutable.
 *
 * @param <T> the message class
 */
final class FieldTable<T extends U2SAData> {
  private static final int WORD = Long.BYTES;

  private final MessageField<T>[] fields;
  private final FieldKey[] keys; // of them
  private final List<MessageField<T>> required = new ArrayList<>();
  private final long[] words; // by index: the first eight bytes of the key, …
  private final long[] masks; // … which bits of them count; at the end one that any word matches
  private final long[] secondWords; // likewise: the next eight, if there are
  private final long[] secondMasks;
  private final NumberKeys numberKeys;
  private final int[] numberIndexes; // by slot: which of the fields it is
  private final long alwaysWritten; // numbers that have a default: bit n is that of slot n
  private final long requiredNumbers; // likewise
  private final ValueField<T, ?>[] values; // of the fields
  private final FieldKey[] valueKeys; // of them
  private final long[] numbersBefore; // by index in values: numbers since the value before
  private final long numbersBehind; // those after the last value
  private final ValueField<T, ?>[] requiredValues;

  FieldTable(List<MessageField<T>> all, int numbers, KeyForm form) {
    fields = fieldArray(all);
    keys = all.stream().map(field -> form.key(field.name())).toArray(FieldKey[]::new);
    words = new long[fields.length + 1];
    masks = new long[fields.length + 1];
    secondWords = new long[fields.length];
    secondMasks = new long[fields.length];
    numberIndexes = new int[numbers];
    NumberField<?>[] bySlot = new NumberField<?>[numbers];
    FieldKey[] keyBySlot = new FieldKey[numbers];
    List<ValueField<T, ?>> valueList = new ArrayList<>();
    List<FieldKey> valueKeyList = new ArrayList<>();
    long[] before = new long[fields.length];
    long since = 0L;
    long defaulted = 0L;
    long needed = 0L;
    for (int index = 0; index < fields.length; index++) {
      MessageField<T> field = fields[index];
      FieldKey key = keys[index];
      long[] bytes = FieldKey.words(key.bytes(), Math.max(2, key.room() / WORD));
      words[index] = bytes[0];
      masks[index] = FieldKey.mask(key.length());
      secondWords[index] = bytes[1];
      secondMasks[index] = FieldKey.mask(key.length() - WORD);
      if (field.isRequired()) {
        required.add(field);
      }
      if (field instanceof NumberField<T> number) {
        long bit = 1L << number.slot;
        bySlot[number.slot] = number;
        keyBySlot[number.slot] = key;
        numberIndexes[number.slot] = index;
        since |= bit;
        defaulted |= Double.isNaN(number.ifUnset) ? 0L : bit;
        needed |= number.isRequired() ? bit : 0L;
      } else if (field instanceof ValueField<T, ?> value) {
        before[valueList.size()] = since;
        since = 0L;
        valueKeyList.add(key);
        valueList.add(value);
      }
    }
    numberKeys = new NumberKeys(bySlot, keyBySlot);
    alwaysWritten = defaulted;
    requiredNumbers = needed;
    values = valueArray(valueList);
    valueKeys = valueKeyList.toArray(new FieldKey[0]);
    numbersBefore = before;
    numbersBehind = since;
    valueList.removeIf(value -> !value.isRequired());
    requiredValues = valueArray(valueList);
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
    boolean isComplete =
        (message.storage().numbersWritten(0L) & requiredNumbers) == requiredNumbers;
    for (ValueField<T, ?> value : requiredValues) {
      isComplete &= value.isSet(message);
    }
    return isComplete ? null : firstMissing(message);
  }

  private MessageField<T> firstMissing(T message) {
    for (MessageField<T> field : required) {
      if (!field.isSet(message)) {
        return field;
      }
    }
    return null;
  }

  /** What of a message is on the wire. */
  Written written(T message) {
    long numbers = message.storage().numbersWritten(alwaysWritten);
    int count = Long.bitCount(numbers);
    int bytes = numberKeys.bytes(numbers);
    for (int i = 0; i < values.length; i++) {
      int more = values[i].expectedBytes(message);
      bytes += more == 0 ? 0 : valueKeys[i].length() + more;
      count += more == 0 ? 0 : 1;
    }
    return new Written(count, bytes);
  }

  /** Writes all fields of a message that are to be written, in their order. */
  void write(CborOutput out, T message) {
    FieldStorage storage = message.storage();
    long written = storage.numbersWritten(alwaysWritten);
    for (int i = 0; i < values.length; i++) {
      out.numbers(numberKeys, storage, written & numbersBefore[i]);
      values[i].write(out, valueKeys[i], message);
    }
    out.numbers(numberKeys, storage, written & numbersBehind);
  }

  /**
   * Which field's key comes next, written as short as can be; it stays there.
   *
   * @param from index of the field to begin with: that after the one before, as writers keep the
   *     order
   * @return the field's index; {@link #size()} if it is none of those, or is before that one
   */
  int find(CborInput in, int from) {
    long word = in.word(0);
    int index = from;
    while ((word & masks[index]) != words[index] || !isRestNext(in, index)) {
      index++;
    }
    boolean isCutOff =
        in.left() < WORD // what is beyond the end looks like zeros
            && index < fields.length
            && keys[index].length() > in.left();
    return isCutOff ? fields.length : index;
  }

  private boolean isRestNext(CborInput in, int index) {
    if (masks[index] != -1L) { // all of it is in the first word, or this is the end
      return true;
    }
    FieldKey key = keys[index];
    return (in.word(WORD) & secondMasks[index]) == secondWords[index]
        && (key.length() <= 2 * WORD || in.isNext(key.bytes(), 2 * WORD));
  }

  /**
   * Reads that number and those that follow it, as {@link NumberKeys#read} does.
   *
   * @return the slots of what was read, a bit each
   */
  long readNumbers(CborInput in, FieldStorage storage, NumberField<T> first, long atMost) {
    return numberKeys.read(in, storage, first.slot, atMost);
  }

  /** The index of the last of those numbers. */
  int indexOfLast(long slots) {
    return numberIndexes[Long.SIZE - 1 - Long.numberOfLeadingZeros(slots)];
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

  /**
   * @param fields how many there are
   * @param bytes how many they take, keys included; exact for texts of ASCII and lists of numbers,
   *     about for what is longer
   */
  record Written(int fields, int bytes) {}
}
