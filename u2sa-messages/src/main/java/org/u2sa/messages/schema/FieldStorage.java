package org.u2sa.messages.schema;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * The values of one message.
 *
 * <p>Most messages set few of the numbers that their type could have. So the numbers that are set
 * stand without gaps in the order of their slots, and a mask says which they are. All else is kept
 * as immutable objects by slot, but for the timestamp, which nearly every message has: it needs no
 * object.
 */
final class FieldStorage {
  private static final double[] NO_NUMBERS = {};
  private static final int ROOM_TO_BEGIN_WITH = 4; // numbers: a position or a velocity

  private double[] numbers = NO_NUMBERS;
  private Object[] values;
  private long present; // bit n: the number of slot n is set
  private long valuesPresent; // likewise: the value
  private long timestampMicros;
  private boolean timed; // the timestamp is set
  private boolean frozen;

  FieldStorage(MessageType.Sizes sizes) {
    values = new Object[sizes.values()];
  }

  /** Which numbers are set, a bit each, by slot. */
  long numbersSet() {
    return present;
  }

  /** Which values are set, a bit each, by slot; the timestamp is none of them. */
  long valuesSet() {
    return valuesPresent;
  }

  /** The numbers that are set, in the order of their slots; nobody changes them. */
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

  /** Where the number of a slot stands or would stand: after all those of lower slots. */
  int indexOf(int slot) {
    return Long.bitCount(present & (1L << slot) - 1);
  }

  /** The value, or the default, or null. */
  @SuppressWarnings(
      "unchecked") // slot and value's class belong to the same field: only put fills it
  <V> V get(ValueField<?, V> field) {
    Object value = values[field.slot];
    return value == null ? field.ifUnset : (V) value;
  }

  /** The timestamp [µs]; 0 if there is none. */
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
   * Keeps numbers as readers come by them: behind all that are set, in a message that is not
   * frozen.
   *
   * @param slots of the numbers, a bit each
   * @param more the numbers in the order of their slots; nobody else changes them any more
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
    if (index < count) { // else it comes last, as in messages that are read or filled in order
      System.arraycopy(old, index, numbers, index + 1, count - index);
    }
  }

  <V> void put(ValueField<?, V> field, V value) {
    requireThawed(field);
    values[field.slot] = value;
    valuesPresent |= 1L << field.slot;
  }

  /** The points of a list, by its slot; none if it is unset. */
  @SuppressWarnings("unchecked") // only lists of points are kept there
  List<Point> points(int slot) {
    return values[slot] == null ? List.of() : (List<Point>) values[slot];
  }

  void timestamp(TimestampField field, long micros) {
    requireThawed(field);
    timestampMicros = micros;
    timed = true;
  }

  /**
   * Takes over all values of another message of the type, and copies of the messages within.
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
   * Freezes this message and the messages within.
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
