package org.u2sa.messages.schema;

import java.nio.ByteBuffer;
import java.util.Arrays;
import org.u2sa.messages.cbor.CborOutput;
import org.u2sa.messages.cbor.FieldKey;

/**
 * A combination of present numbers of a {@link NumberRun}: their encoded bytes without the values,
 * and the values' offsets. Immutable.
 *
 * <p>The loops wrap the array in a local {@link ByteBuffer}, which escape analysis removes.
 */
final class NumberPattern implements CborOutput.Pattern {
  private static final int WORD = Long.BYTES;

  final long set;
  private final boolean isWhole; // everything written is set
  final int last;
  private final byte[] bytes;
  private final int[] places; // offsets of the values, in slot order
  private final double[] bounds; // minimum and maximum of each value
  private final int[] keyPlaces; // offsets of eight-byte words that cover all keys
  private final long[] keyWords; // word and mask of key bits at each offset

  /**
   * @param fields all fields of the run
   * @param keys keys of the fields
   * @param set mask of the numbers in the message, by slot
   * @param written likewise, plus the numbers written with their defaults
   */
  NumberPattern(NumberField<?>[] fields, FieldKey[] keys, long set, long written) {
    this.set = set;
    isWhole = set == written;
    int count = Long.bitCount(set);
    places = new int[count];
    bounds = new double[2 * count];
    CborOutput out = new CborOutput();
    WordList words = new WordList();
    int values = 0;
    int lastSet = 0;
    for (int i = 0; i < fields.length; i++) {
      long bit = 1L << fields[i].slot;
      if ((written & bit) == 0L) {
        continue;
      }
      int start = out.length();
      out.item(keys[i].bytes());
      out.number((set & bit) == 0L ? fields[i].ifUnset : 0.0);
      int place = out.length() - WORD;
      words.cover(start, place);
      if ((set & bit) != 0L) {
        lastSet = i;
        places[values] = place;
        bounds[2 * values] = fields[i].least;
        bounds[2 * values++ + 1] = fields[i].most;
      }
    }
    last = lastSet;
    bytes = out.toBytes();
    keyPlaces = words.places();
    keyWords = words.of(bytes);
  }

  int count() {
    return places.length;
  }

  @Override
  public int length() {
    return bytes.length;
  }

  @Override
  public int put(byte[] into, int at, double[] numbers, int first) {
    System.arraycopy(bytes, 0, into, at, bytes.length);
    ByteBuffer view = ByteBuffer.wrap(into);
    for (int i = 0; i < places.length; i++) {
      view.putDouble(at + places[i], numbers[first + i]);
    }
    return at + bytes.length;
  }

  /**
   * The values, if the bytes are these keys, each followed by a float64 within its field's bounds;
   * else null.
   */
  double[] read(byte[] from, int at) {
    if (!isWhole || from.length - at < bytes.length || !hasKeysAt(from, at)) {
      return null;
    }
    ByteBuffer view = ByteBuffer.wrap(from);
    double[] values = new double[places.length];
    boolean isWithin = true;
    for (int i = 0; i < values.length; i++) {
      double value = view.getDouble(at + places[i]);
      isWithin &= value >= bounds[2 * i] & value <= bounds[2 * i + 1]; // false for NaN
      values[i] = value;
    }
    return isWithin ? values : null;
  }

  private boolean hasKeysAt(byte[] from, int at) {
    ByteBuffer view = ByteBuffer.wrap(from);
    long differing = 0L;
    for (int i = 0; i < keyPlaces.length; i++) {
      differing |= (view.getLong(at + keyPlaces[i]) ^ keyWords[2 * i]) & keyWords[2 * i + 1];
    }
    return differing == 0L;
  }

  /** Words that cover keys, including the first byte of each float64. */
  private static final class WordList {
    private int[] places = new int[Long.SIZE];
    private long[] masks = new long[Long.SIZE];
    private int count;

    void cover(int start, int end) {
      for (int place = start; place < end; place += WORD) {
        if (count == places.length) {
          places = Arrays.copyOf(places, 2 * count);
          masks = Arrays.copyOf(masks, 2 * count);
        }
        places[count] = place;
        masks[count++] = FieldKey.mask(end - place);
      }
    }

    int[] places() {
      return Arrays.copyOf(places, count);
    }

    /** Each word followed by its mask. */
    long[] of(byte[] bytes) {
      ByteBuffer view = ByteBuffer.wrap(bytes);
      long[] words = new long[2 * count];
      for (int i = 0; i < count; i++) {
        words[2 * i] = view.getLong(places[i]); // an eight-byte value follows each key
        words[2 * i + 1] = masks[i];
      }
      return words;
    }
  }
}
