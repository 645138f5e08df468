package org.u2sa.messages.schema;

import java.util.Arrays;
import java.util.List;

/**
 * The values of one message, by slot.
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
  private boolean timed; // whether the timestamp is set
  private boolean frozen;

  FieldStorage(int values) {
    this.values = new Object[values];
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

  boolean hasNumber(int slot) {
    return (present >>> slot & 1L) != 0L;
  }

  boolean hasTimestamp() {
    return timed;
  }

  double number(int slot, double ifUnset) {
    return hasNumber(slot) ? numbers[indexOf(slot)] : ifUnset;
  }

  /** Index of a slot's number, whether set or not: after all lower slots. */
  int indexOf(int slot) {
    return Long.bitCount(present & (1L << slot) - 1);
  }

  /** A value other than a number; null if unset. */
  Object value(int slot) {
    return values[slot];
  }

  /** The timestamp [µs]; 0 if absent. */
  long timestamp() {
    return timestampMicros;
  }

  void put(int slot, double value) {
    int index = indexOf(slot);
    if (!hasNumber(slot)) {
      makeRoomAt(index);
      present |= 1L << slot;
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

  void put(int slot, Object value) {
    values[slot] = value;
    valuesPresent |= 1L << slot;
  }

  /** Elements of the list in a slot; empty if unset. */
  List<?> list(int slot) {
    return values[slot] == null ? List.of() : (List<?>) values[slot];
  }

  void timestamp(long micros) {
    timestampMicros = micros;
    timed = true;
  }

  /** Copies all values of another message of the type; they share nested messages. */
  void takeFrom(FieldStorage other) {
    present = other.present;
    numbers = Arrays.copyOf(other.numbers, Long.bitCount(present));
    values = other.values.clone();
    valuesPresent = other.valuesPresent;
    timestampMicros = other.timestampMicros;
    timed = other.timed;
  }

  void freeze() {
    frozen = true;
  }

  boolean isFrozen() {
    return frozen;
  }
}
