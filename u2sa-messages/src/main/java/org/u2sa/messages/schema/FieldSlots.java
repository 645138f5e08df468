package org.u2sa.messages.schema;

/** Allocates storage and presence bits to the fields of one class, after those of its parent. */
final class FieldSlots {
  private static final int MAX = Long.SIZE; // presence is one long

  record Sizes(int numbers, int values, int bits) {}

  private int numbers;
  private int values;
  private int bits;

  /** Sizes of the parent, where its child continues. */
  static FieldSlots after(Sizes parent) {
    FieldSlots slots = new FieldSlots();
    slots.numbers = parent.numbers();
    slots.values = parent.values();
    slots.bits = parent.bits();
    return slots;
  }

  int number() {
    return within(numbers++);
  }

  int value() {
    return within(values++);
  }

  int bit() {
    return within(bits++);
  }

  private static int within(int taken) {
    if (taken >= MAX) {
      throw new IllegalArgumentException(
          String.format(
              "a message has at most %1$s numbers, %1$s other values and %1$s presence bits", MAX));
    }
    return taken;
  }

  Sizes sizes() {
    return new Sizes(numbers, values, bits);
  }
}
