package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.util.Map;

/**
 * How the fields of each kind of record follow one another, as far as it decides how long a record
 * is: a record's length stands both in its prefix and in the lengths of its fields. Source:
 * mcap.dev/spec.
 */
final class RecordLayout {
  private static final int SHORT_LENGTH = -4; // a field that begins with its length in 4 bytes
  private static final int LONG_LENGTH = -8; // the same in 8 bytes

  /** By opcode; a positive number stands for that many bytes. */
  private static final Map<Integer, int[]> FIELDS =
      Map.ofEntries(
          Map.entry(Opcode.HEADER, new int[] {SHORT_LENGTH, SHORT_LENGTH}),
          Map.entry(Opcode.FOOTER, new int[] {20}),
          Map.entry(Opcode.SCHEMA, new int[] {2, SHORT_LENGTH, SHORT_LENGTH, SHORT_LENGTH}),
          Map.entry(Opcode.CHANNEL, new int[] {4, SHORT_LENGTH, SHORT_LENGTH, SHORT_LENGTH}),
          Map.entry(Opcode.MESSAGE, new int[] {McapMessage.FIXED}),
          Map.entry(Opcode.CHUNK, new int[] {28, SHORT_LENGTH, LONG_LENGTH}),
          Map.entry(Opcode.MESSAGE_INDEX, new int[] {2, SHORT_LENGTH}),
          Map.entry(Opcode.CHUNK_INDEX, new int[] {32, SHORT_LENGTH, 8, SHORT_LENGTH, 16}),
          Map.entry(Opcode.ATTACHMENT, new int[] {16, SHORT_LENGTH, SHORT_LENGTH, LONG_LENGTH, 4}),
          Map.entry(Opcode.ATTACHMENT_INDEX, new int[] {40, SHORT_LENGTH, SHORT_LENGTH}),
          Map.entry(Opcode.STATISTICS, new int[] {42, SHORT_LENGTH}),
          Map.entry(Opcode.METADATA, new int[] {SHORT_LENGTH, SHORT_LENGTH}),
          Map.entry(Opcode.METADATA_INDEX, new int[] {16, SHORT_LENGTH}),
          Map.entry(Opcode.SUMMARY_OFFSET, new int[] {17}),
          Map.entry(Opcode.DATA_END, new int[] {4}));

  private RecordLayout() {}

  static boolean isKnown(int opcode) {
    return FIELDS.containsKey(opcode);
  }

  /**
   * Length of a record's fields by what they say themselves [B]; for a message, which does not say
   * how long its data are, its other fields. -1: the file ends before they do.
   *
   * @param at where the record's content begins
   */
  static long length(int opcode, FileWindow file, long at) throws IOException {
    long end = at;
    for (int field : FIELDS.get(opcode)) {
      if (field > 0) {
        end += field;
        continue;
      }
      if (end - field > file.size()) {
        return -1;
      }
      long length = field == SHORT_LENGTH ? file.uint32(end) : file.uint64(end);
      if (length < 0 || length > Long.MAX_VALUE / 2) {
        return -1;
      }
      end += length - field;
      if (end < 0) {
        return -1;
      }
    }
    return end - at;
  }
}
