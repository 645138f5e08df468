package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * The values of one message.
 *
 * <p>Most messages set few of their type's numbers, so the set numbers are stored without gaps in
 * slot order, with a mask of the used slots. All other values are immutable objects by slot, except
 * the timestamp, which nearly every message has and which is kept unboxed.
 */
final class FieldStorage {
  private static final double[] NO_NUMBERS = {};
  private static final int ROOM_TO_BEGIN_WITH = 4; // enough for a position or a velocity

  private double[] numbers = NO_NUMBERS;
  private Object[] values;
  private long present; // bit n: the number of slot n is set
  private long valuesPresent; // likewise for values
  private long timestampMicros;
  private boolean timed; // the timestamp is set
  private boolean frozen;

  FieldStorage(MessageType.Sizes sizes) {
    values = new Object[sizes.values()];
  }

  /** Mask of set numbers, by slot. */
  long numbersSet() {
    return present;
  }

  /** Mask of set values, by slot; excludes the timestamp. */
  long valuesSet() {
    return valuesPresent;
  }

  /** Set numbers in slot order; not to be modified. */
  double[] numbers() {
    return numbers;
  }

  boolean has(NumberField<?> field) {
    return (present >>> field.slot & 1L) != 0L;
  }

  boolean has(ValueField<?, ?> field) {
    return values[field.slot] != null;
  }

  boolean hasTimestamp() {
    return timed;
  }

  /** The value, or the default, or NaN. */
  double get(NumberField<?> field) {
    return has(field) ? numbers[indexOf(field.slot)] : field.ifUnset;
  }

  /** Index of a slot's number, whether set or not: after all lower slots. */
  int indexOf(int slot) {
    return Long.bitCount(present & (1L << slot) - 1);
  }

  /** The value, or the default, or null. */
  @SuppressWarnings("unchecked") // only put fills the slot, with the class of the same field
  <V> V get(ValueField<?, V> field) {
    Object value = values[field.slot];
    return value == null ? field.ifUnset : (V) value;
  }

  /** The timestamp [µs]; 0 if absent. */
  long timestamp() {
    return timestampMicros;
  }

  void put(NumberField<?> field, double value) {
    requireThawed(field);
    int index = indexOf(field.slot);
    if (!has(field)) {
      makeRoomAt(index);
      present |= 1L << field.slot;
    }
    numbers[index] = value;
  }

  /**
   * Appends numbers in reading order, after all set ones, to a message that is not frozen.
   *
   * @param slots mask of the numbers' slots
   * @param more the numbers in slot order; the caller must not modify the array afterwards
   */
  void append(long slots, double[] more) {
    int count = Long.bitCount(present);
    if (count == 0) {
      numbers = more;
    } else {
      numbers = Arrays.copyOf(numbers, count + more.length);
      System.arraycopy(more, 0, numbers, count, more.length);
    }
    present |= slots;
  }

  private void makeRoomAt(int index) {
    int count = Long.bitCount(present);
    double[] old = numbers;
    if (count == old.length) {
      numbers = Arrays.copyOf(old, Math.min(2 * count + ROOM_TO_BEGIN_WITH, Long.SIZE));
    }
    if (index < count) { // otherwise append: the usual case when reading or filling in order
      System.arraycopy(old, index, numbers, index + 1, count - index);
    }
  }

  <V> void put(ValueField<?, V> field, V value) {
    requireThawed(field);
    values[field.slot] = value;
    valuesPresent |= 1L << field.slot;
  }

  /** Points of the list in a slot; empty if unset. */
  @SuppressWarnings("unchecked") // the slot holds only lists of points
  List<Point> points(int slot) {
    return values[slot] == null ? List.of() : (List<Point>) values[slot];
  }

  void timestamp(TimestampField field, long micros) {
    requireThawed(field);
    timestampMicros = micros;
    timed = true;
  }

  /**
   * Copies all values of another message of the type, including nested messages.
   *
   * @param messageLists slots of the lists that hold them
   */
  void takeFrom(FieldStorage other, int[] messageLists) {
    present = other.present;
    numbers = Arrays.copyOf(other.numbers, Long.bitCount(present));
    values = other.values.clone();
    valuesPresent = other.valuesPresent;
    timestampMicros = other.timestampMicros;
    timed = other.timed;
    for (int slot : messageLists) {
      if (values[slot] != null) {
        values[slot] = copies((List<?>) values[slot]);
      }
    }
  }

  private static List<U2SAData> copies(List<?> messages) {
    List<U2SAData> copies = new ArrayList<>(messages.size());
    for (Object message : messages) {
      copies.add(((U2SAData) message).copy());
    }
    return List.copyOf(copies);
  }

  private void requireThawed(MessageField<?> field) {
    if (frozen) {
      throw new IllegalStateException(
          field.path() + " cannot be set: the message is frozen since it was published; copy() it");
    }
  }

  /**
   * Freezes this message and nested ones.
   *
   * @param messageLists slots of the lists that hold them
   */
  void freeze(int[] messageLists) {
    for (int slot : messageLists) {
      if (values[slot] != null) {
        for (Object element : (List<?>) values[slot]) {
          ((U2SAData) element).freeze();
        }
      }
    }
    frozen = true;
  }

  boolean isFrozen() {
    return frozen;
  }
}
