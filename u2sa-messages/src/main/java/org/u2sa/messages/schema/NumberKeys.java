package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.util.Arrays;

/**
 * The keys of a type's numbers by slot, each with the first byte of a float64 behind it, side by
 * side in one array. A state has 48 numbers: they are written and read one after the other in two
 * short loops, eight bytes at a time. Immutable.
 *
 * <p>The loops make their own {@link ByteBuffer}: a compiler sees that nobody else has it, leaves
 * it out and keeps the rows' addresses in registers.
 */
final class NumberKeys {
  private static final int WORD = Long.BYTES;
  private static final int WORDS = 3; // of name and first byte; few names are longer
  private static final int LENGTH = 2 * WORDS; // in a row: words, their masks, length
  private static final int ROW = 8;

  private final NumberField<?>[] fields;
  private final FieldKey[] keys; // of them
  private final long[] rows;
  private final long[] lengthBits; // by bit of a row's length: the slots whose lengths have it

  NumberKeys(NumberField<?>[] fields, FieldKey[] keys) {
    this.fields = fields;
    this.keys = keys;
    rows = new long[fields.length * ROW];
    for (int slot = 0; slot < fields.length; slot++) {
      byte[] name = keys[slot].bytes();
      byte[] bytes = Arrays.copyOf(name, name.length + 1);
      bytes[name.length] = (byte) Cbor.FLOAT_64;
      long[] words = FieldKey.words(bytes, Math.max(WORDS, keys[slot].room() / WORD + 1));
      for (int word = 0; word < WORDS; word++) {
        rows[slot * ROW + word] = words[word];
        rows[slot * ROW + WORDS + word] = FieldKey.mask(bytes.length - word * WORD);
      }
      rows[slot * ROW + LENGTH] = bytes.length;
    }
    lengthBits = lengthBits();
  }

  private long[] lengthBits() {
    long longest = 0L;
    for (int row = 0; row < rows.length; row += ROW) {
      longest = Math.max(longest, rows[row + LENGTH]);
    }
    long[] slots = new long[Long.SIZE - Long.numberOfLeadingZeros(longest)];
    for (int bit = 0; bit < slots.length; bit++) {
      for (int slot = 0; slot < fields.length; slot++) {
        slots[bit] |= (rows[slot * ROW + LENGTH] >>> bit & 1L) << slot;
      }
    }
    return slots;
  }

  /** How many bytes the numbers of those slots take with their keys. */
  int bytes(long slots) {
    int sum = Long.bitCount(slots) * WORD;
    for (int bit = 0; bit < lengthBits.length; bit++) {
      sum += Long.bitCount(slots & lengthBits[bit]) << bit;
    }
    return sum;
  }

  /**
   * Writes the numbers of those slots with their names. There must be room for them and no more:
   * what is beyond the end of a name's last word, the number covers.
   *
   * @return where they end
   */
  int put(byte[] bytes, int start, FieldStorage storage, long slots) {
    ByteBuffer into = ByteBuffer.wrap(bytes);
    long[] words = rows;
    double[] numbers = storage.numbers();
    long present = storage.numbersWritten(0L);
    int next = Long.bitCount(present & (Long.lowestOneBit(slots) - 1L)); // of the numbers
    int at = start;
    for (long left = slots; left != 0L; left &= left - 1) {
      int slot = Long.numberOfTrailingZeros(left);
      int row = slot * ROW;
      int length = (int) words[row + LENGTH];
      into.putLong(at, words[row]);
      if (length > WORD) {
        into.putLong(at + WORD, words[row + 1]);
        if (length > 2 * WORD) {
          into.putLong(at + 2 * WORD, words[row + 2]);
          if (length > WORDS * WORD) {
            System.arraycopy(keys[slot].bytes(), 0, bytes, at, length - 1);
            bytes[at + length - 1] = (byte) Cbor.FLOAT_64;
          }
        }
      }
      at += length;
      boolean isSet = (present >>> slot & 1L) != 0L;
      into.putDouble(at, isSet ? numbers[next++] : fields[slot].ifUnset);
      at += WORD;
    }
    return at;
  }

  /**
   * Reads numbers as writers write them: in order, as float64, each within its bounds. Ends before
   * whatever else there is, for others to read or to refuse.
   *
   * @param firstSlot none of a lower one is read
   * @param atMost how many there can be
   * @return the slots of what was read, a bit each
   */
  long read(CborInput in, FieldStorage storage, int firstSlot, long atMost) {
    byte[] bytes = in.bytes();
    ByteBuffer from = ByteBuffer.wrap(bytes);
    long[] words = rows;
    int at = in.offset();
    long taken = 0L;
    long left = atMost;
    for (int slot = firstSlot; slot < fields.length && bytes.length - at > WORD; slot++) {
      int row = slot * ROW;
      if ((from.getLong(at) & words[row + WORDS]) != words[row]) {
        continue;
      }
      int length = (int) words[row + LENGTH];
      if (bytes.length - at < length + WORD || !isRestAt(bytes, at, words, row)) {
        continue;
      }
      double value = from.getDouble(at + length);
      long more = Math.min(left, fields.length - slot);
      if (more == 0 || !fields[slot].takes(value) || !storage.append(slot, value, (int) more)) {
        break;
      }
      at += length + WORD;
      left--;
      taken |= 1L << slot;
    }
    in.passTo(at);
    return taken;
  }

  /** Whether the row stands there, of which the first word does; a number follows within bounds. */
  private static boolean isRestAt(byte[] bytes, int at, long[] words, int row) {
    ByteBuffer from = ByteBuffer.wrap(bytes);
    long length = words[row + LENGTH];
    return length <= WORD
        || (from.getLong(at + WORD) & words[row + WORDS + 1]) == words[row + 1]
            && (length <= 2 * WORD
                || length <= WORDS * WORD
                    && (from.getLong(at + 2 * WORD) & words[row + WORDS + 2]) == words[row + 2]);
  }
}
