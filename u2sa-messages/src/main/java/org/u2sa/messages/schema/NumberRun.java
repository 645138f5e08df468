package org.u2sa.messages.schema;

import java.util.List;
import org.u2sa.messages.cbor.CborInput;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;

/**
 * Consecutive number fields of a type on the wire.
 *
 * <p>Publishers set the same numbers in every message, so the run caches the patterns it has met: a
 * known pattern is written by copying its bytes and filling in the values, and read by comparing
 * them. Thread-safe: a pattern not yet visible to another thread is merely created twice.
 */
final class NumberRun {
  private static final int REMEMBERED_BITS = 4;
  private static final int REMEMBERED = 1 << REMEMBERED_BITS;
  private static final long GOLDEN_RATIO = 0x9E37_79B9_7F4A_7C15L; // spreads hash values

  final int start;
  private final NumberField<?>[] fields;
  private final FieldKey[] keys; // keys of the fields
  private final int firstSlot;
  private final long slots; // mask of all slots
  private final long defaulted; // mask of those always written
  private final NumberPattern[] written = new NumberPattern[REMEMBERED]; // by numbers set
  private final NumberPattern[] expected = new NumberPattern[REMEMBERED]; // by fingerprint

  /**
   * @param start number of fields of the type before it
   * @param fields fields in wire order, which is slot order
   * @param keys keys of the fields
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

  void write(CborOutput out, FieldStorage storage) {
    long set = storage.numbersSet() & slots;
    if ((set | defaulted) != 0L) {
      out.numbers(patternOf(set), storage.numbers(), storage.indexOf(firstSlot));
    }
  }

  private NumberPattern patternOf(long set) {
    int index = hash(set);
    NumberPattern known = written[index];
    if (known == null || known.set != set) {
      known = new NumberPattern(fields, keys, set, set | defaulted);
      written[index] = known;
    }
    return known;
  }

  /**
   * Fast path: reads the same numbers as the last map with this fingerprint, if present. Otherwise
   * reads nothing; the caller then reads the numbers individually and calls {@link #expect}.
   *
   * @param storage storage of a message without these and any later numbers
   * @param pairs number of pairs in the map
   * @param atMost maximum number of numbers
   * @return pattern read; null if none
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
    storage.append(pattern.set, values);
    in.passTo(in.offset() + pattern.length());
    return pattern;
  }

  /**
   * Fingerprint that distinguishes maps with different numbers as far as possible; taken before the
   * first number is read.
   */
  static long opening(CborInput in, long pairs) {
    return pairs << Short.SIZE | in.word() >>> Long.SIZE - Short.SIZE;
  }

  /** Remembers the numbers of a map with this fingerprint. */
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
