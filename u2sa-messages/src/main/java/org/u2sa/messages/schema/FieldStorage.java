package org.u2sa.messages.schema;

import java.util.List;

/**
 * The values of one message, by slot: numbers unboxed with a mask of those that are set, all else
 * as immutable objects.
 */
final class FieldStorage {
  private final double[] numbers;
  private final Object[] values;
  private long present; // bit n: numbers[n] is set
  private boolean frozen;

  FieldStorage(MessageType.Sizes sizes) {
    numbers = new double[sizes.numbers()];
    values = new Object[sizes.values()];
  }

  /** Which numbers are set or among those that are always written, a bit each, by slot. */
  long numbersWritten(long always) {
    return present | always;
  }

  boolean has(NumberField<?> field) {
    return (present >>> field.slot & 1L) != 0L;
  }

  boolean has(ValueField<?, ?> field) {
    return values[field.slot] != null;
  }

  /** The value, or the default, or NaN. */
  double get(NumberField<?> field) {
    return has(field) ? numbers[field.slot] : field.ifUnset;
  }

  /** The value, or the default, or null. */
  @SuppressWarnings(
      "unchecked") // slot and value's class belong to the same field: only put fills it
  <V> V get(ValueField<?, V> field) {
    Object value = values[field.slot];
    return value == null ? field.ifUnset : (V) value;
  }

  void put(NumberField<?> field, double value) {
    requireThawed(field);
    numbers[field.slot] = value;
    present |= 1L << field.slot;
  }

  <V> void put(ValueField<?, V> field, V value) {
    requireThawed(field);
    values[field.slot] = value;
  }

  private void requireThawed(MessageField<?> field) {
    if (frozen) {
      throw new IllegalStateException(
          field.path() + " cannot be set: the message is frozen since it was published; copy() it");
    }
  }

  /** Freezes this message and the messages within. */
  void freeze() {
    for (Object value : values) {
      if (value instanceof List<?> list && holdsMessages(list)) {
        for (Object element : list) {
          ((U2SAData) element).freeze();
        }
      }
    }
    frozen = true;
  }

  /** The first element tells: a list is of one kind. */
  private static boolean holdsMessages(List<?> list) {
    return !(list instanceof DeferredTexts) && !list.isEmpty() && list.get(0) instanceof U2SAData;
  }

  boolean isFrozen() {
    return frozen;
  }
}
