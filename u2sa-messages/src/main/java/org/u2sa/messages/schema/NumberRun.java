package org.u2sa.messages.schema;

import java.util.List;

/**
 * Numbers of a type that follow one another on the wire, with no field of another kind between
 * them.
 *
 * <p>A publisher sets the same numbers in every message, so the run remembers the patterns that it
 * has met: a message of a known pattern is written by copying its bytes and filling in the values,
 * and read by comparing them. Safe for all threads: a pattern that one thread stores and another
 * does not see is only made twice.
 */
final class NumberRun {
  private static final int REMEMBERED_BITS = 4;
  private static final int REMEMBERED = 1 << REMEMBERED_BITS;
  private static final long GOLDEN_RATIO = 0x9E37_79B9_7F4A_7C15L; // spreads what is hashed

  private final int start;
  private final NumberField<?>[] fields;
  private final FieldKey[] keys; // of them
  private final int firstSlot;
  private final long slots; // of all, a bit each
  private final long defaulted; // likewise: those that are always written
  private final NumberPattern[] written = new NumberPattern[REMEMBERED]; // by numbers set
  private final NumberPattern[] expected = new NumberPattern[REMEMBERED]; // by how a map opens

  /**
   * @param start how many fields of the type are before it
   * @param fields in wire order, which is that of their slots
   * @param keys of them
   */
  NumberRun(int start, List<NumberField<?>> fields, List<FieldKey> keys) {
    this.start = start;
    this.fields = fields.toArray(new NumberField<?>[0]);
    this.keys = keys.toArray(new FieldKey[0]);
    firstSlot = fields.get(0).slot;
    long all = 0L;
    long always = 0L;
    for (NumberField<?> field : fields) {
      all |= 1L << field.slot;
      always |= Double.isNaN(field.ifUnset) ? 0L : 1L << field.slot;
    }
    slots = all;
    defaulted = always;
  }

  /** How many fields of the type are before it. */
  int start() {
    return start;
  }

  /** Writes those that are set or have a default. */
  void write(CborOutput out, FieldStorage storage) {
    long set = storage.numbersSet() & slots;
    if ((set | defaulted) != 0L) {
      out.numbers(patternOf(set), storage.numbers(), storage.indexOf(firstSlot));
    }
  }

  private NumberPattern patternOf(long set) {
    int index = hash(set);
    NumberPattern known = written[index];
    if (known == null || known.set() != set) {
      known = new NumberPattern(fields, keys, set, set | defaulted);
      written[index] = known;
    }
    return known;
  }

  /**
   * Reads the numbers that the last map had that opened alike, if they are there. Else reads
   * nothing; whoever then reads them one by one calls {@link #expect}.
   *
   * @param storage of a message that has none of them yet, nor any behind them
   * @param pairs of the map
   * @param atMost how many numbers there can be
   * @return which were read; null if none
   */
  NumberPattern read(CborInput in, FieldStorage storage, long pairs, long atMost) {
    NumberPattern pattern = expected[hash(opening(in, pairs))];
    if (pattern == null || pattern.count() > atMost) {
      return null;
    }
    double[] values = pattern.read(in.bytes(), in.offset());
    if (values == null) {
      return null;
    }
    storage.append(pattern.set(), values);
    in.passTo(in.offset() + pattern.length());
    return pattern;
  }

  /**
   * What tells apart maps that have different numbers, as far as possible. To be asked for where
   * the first of them comes next.
   */
  static long opening(CborInput in, long pairs) {
    return pairs << Short.SIZE | in.word() >>> Long.SIZE - Short.SIZE;
  }

  /** Remembers which numbers a map had that opened so. */
  void expect(long opening, FieldStorage storage) {
    long set = storage.numbersSet() & slots;
    if (set != 0L) {
      expected[hash(opening)] = patternOf(set);
    }
  }

  private static int hash(long value) {
    return (int) (value * GOLDEN_RATIO >>> Long.SIZE - REMEMBERED_BITS);
  }
}
