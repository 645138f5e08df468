package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.util.Map;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.Opcode;

/**
 * Field layout of each record type, as far as it determines a record's length. The length is
 * redundant: the prefix and the fields' lengths both contain it. Source: mcap.dev/spec.
 */
final class RecordLayout {
  private static final int SHORT_LENGTH = -4; // field with a 4-byte length prefix
  private static final int LONG_LENGTH = -8; // field with an 8-byte length prefix

  /** By opcode; a positive number is a fixed size in bytes. */
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
   * Length of a record's fields according to their own lengths [B]; excludes the payload of a
   * message, whose length is not stored. -1 if the file ends earlier.
   *
   * @param at offset of the record's content
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
