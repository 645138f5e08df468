package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.nio.channels.SeekableByteChannel;
import java.util.function.Consumer;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.Opcode;

/**
 * Finds the records of a possibly damaged file. If a record's length is implausible, uses the
 * length that leads to another record, or else searches for the next one. Not thread-safe.
 */
final class RecordSearch {
  private static final int FIRST_PRIVATE = 0x80; // first opcode for private use

  private final FileWindow file;
  private final long end; // of the records, before the magic bytes
  private final boolean isCut;
  private final Consumer<String> trouble;
  private boolean hasChunks;
  private boolean isSummary; // whether the data section has ended: no messages follow
  private long position = Opcode.magic().length;

  /**
   * A record found.
   *
   * @param offset file offset of its prefix [B]
   * @param opcode its opcode
   * @param length length of its content present in the file [B]
   * @param isCut whether the file ends within the record
   */
  record Found(long offset, int opcode, long length, boolean isCut) {
    long contentAt() {
      return offset + Opcode.PREFIX;
    }

    long end() {
      return contentAt() + length;
    }
  }

  RecordSearch(SeekableByteChannel channel, Consumer<String> trouble) throws IOException {
    this.trouble = trouble;
    file = new FileWindow(channel);
    requireMagicAt(0, channel);
    long lastMagic = Math.max(0, file.size() - Opcode.magic().length);
    isCut = lastMagic == 0 || !isMagicAt(lastMagic, channel);
    end = isCut ? file.size() : lastMagic;
  }

  private void requireMagicAt(long at, SeekableByteChannel channel) throws IOException {
    try {
      RecordStream.requireMagic(channel, at);
    } catch (McapException e) {
      trouble.accept(e.getMessage());
    }
  }

  private static boolean isMagicAt(long at, SeekableByteChannel channel) throws IOException {
    try {
      RecordStream.requireMagic(channel, at);
      return true;
    } catch (McapException e) {
      return false;
    }
  }

  /** Random access to the file. */
  FileWindow file() {
    return file;
  }

  /** Next record; null at the end of the file. */
  Found next() throws IOException {
    if (position >= end) {
      if (isCut) {
        trouble.accept("the file breaks off at byte " + file.size());
      }
      return null;
    }
    Found found = at(position);
    if (found == null) {
      found = searchFrom(position + 1);
      trouble.accept(
          found == null && breaksOffWithin(position)
              ? breaksOffWithinRecord()
              : "at byte " + position + " there is no record, or it is damaged");
    }
    position = found == null ? end : found.end();
    hasChunks |= found != null && found.opcode == Opcode.CHUNK;
    isSummary |= found != null && found.opcode == Opcode.DATA_END;
    if (found != null && found.isCut) {
      trouble.accept(breaksOffWithinRecord());
    }
    return found;
  }

  private String breaksOffWithinRecord() {
    return "the file breaks off at byte " + file.size() + ", within a record";
  }

  /** Whether a record truncated by the end of the file starts here. */
  private boolean breaksOffWithin(long at) throws IOException {
    if (!isCut || end - at < Opcode.PREFIX) {
      return isCut;
    }
    int opcode = file.uint8(at);
    long length = file.uint64(at + 1);
    return (RecordLayout.isKnown(opcode) || opcode >= FIRST_PRIVATE)
        && length > 0
        && length <= ReadLimits.MAX_LENGTH
        && !fits(at, length);
  }

  private Found at(long at) throws IOException {
    if (at + Opcode.PREFIX > end) {
      return null;
    }
    int opcode = file.uint8(at);
    long length = file.uint64(at + 1);
    long ofFields =
        RecordLayout.isKnown(opcode) ? RecordLayout.length(opcode, file, at + Opcode.PREFIX) : 0;
    if (length == ofFields && opcode != Opcode.MESSAGE && fits(at, length)) {
      return new Found(at, opcode, length, false);
    }
    if (opcode != Opcode.CHUNK && isLaidOutAs(Opcode.CHUNK, at, length)) {
      trouble.accept("the chunk at byte " + at + " has a damaged opcode");
      return new Found(at, Opcode.CHUNK, length, false);
    }
    if (hasChunks && opcode == Opcode.MESSAGE && isLaidOutAs(Opcode.MESSAGE_INDEX, at, length)) {
      return new Found(at, Opcode.MESSAGE_INDEX, length, false);
    }
    if (opcode == 0
        || opcode == Opcode.DATA_END
        || opcode == Opcode.FOOTER
        || isSummary && opcode == Opcode.MESSAGE) {
      return null;
    }
    boolean hasFields = opcode != Opcode.MESSAGE && ofFields > 0;
    boolean isTooLong = // where both lengths lead to a record, the shorter one loses less
        hasFields && length > ofFields && isExactRecord(at + Opcode.PREFIX + ofFields);
    if (!isTooLong && leadsToRecord(at, length)) { // later versions may add fields
      return new Found(at, opcode, length, false);
    }
    if (hasFields && leadsToRecord(at, ofFields)) {
      trouble.accept("the record at byte " + at + " has a damaged length");
      return new Found(at, opcode, ofFields, false);
    }
    return isCutChunk(opcode, at, length, ofFields)
        ? new Found(at, opcode, end - at - Opcode.PREFIX, true)
        : null;
  }

  private boolean isLaidOutAs(int opcode, long at, long length) throws IOException {
    return fits(at, length)
        && length > 0
        && RecordLayout.length(opcode, file, at + Opcode.PREFIX) == length;
  }

  private boolean isCutChunk(int opcode, long at, long length, long ofFields) {
    return isCut && opcode == Opcode.CHUNK && length == ofFields && !fits(at, length);
  }

  private boolean fits(long at, long length) {
    return length >= 0 && length <= end - at - Opcode.PREFIX;
  }

  /** Whether a record of this length is followed by another record or the end of the file. */
  private boolean leadsToRecord(long at, long length) throws IOException {
    return fits(at, length) && isRecord(at + Opcode.PREFIX + length);
  }

  private boolean isRecord(long at) throws IOException {
    if (at == end || isCut && at + Opcode.PREFIX > end) {
      return true;
    }
    if (at + Opcode.PREFIX > end) {
      return false;
    }
    int opcode = file.uint8(at);
    long length = file.uint64(at + 1);
    if (!RecordLayout.isKnown(opcode)) {
      return opcode >= FIRST_PRIVATE && length > 0 && fits(at, length);
    }
    long ofFields = RecordLayout.length(opcode, file, at + Opcode.PREFIX);
    return isCut && !fits(at, length)
        ? length > 0 && length <= ReadLimits.MAX_LENGTH
        : fits(at, length) && ofFields >= 0 && ofFields <= length;
  }

  /** Whether the record at an offset is as long as its fields say; never of a message. */
  private boolean isExactRecord(long at) throws IOException {
    if (at + Opcode.PREFIX > end) {
      return false;
    }
    int opcode = file.uint8(at);
    return opcode != Opcode.MESSAGE
        && RecordLayout.isKnown(opcode)
        && isLaidOutAs(opcode, at, file.uint64(at + 1));
  }

  /** First record from an offset whose length is certain. */
  private Found searchFrom(long from) throws IOException {
    for (long at = from; at + Opcode.PREFIX <= end; at++) {
      int opcode = file.uint8(at);
      if (!RecordLayout.isKnown(opcode) || opcode == Opcode.HEADER) {
        continue;
      }
      long length = file.uint64(at + 1);
      if (length <= 0 || length > ReadLimits.MAX_LENGTH) {
        continue;
      }
      long ofFields = RecordLayout.length(opcode, file, at + Opcode.PREFIX);
      boolean isCertain = // messages do not store their length; not expected beside chunks
          opcode == Opcode.MESSAGE
              ? !hasChunks && !isSummary && ofFields > 0 && ofFields <= length
              : ofFields == length;
      if (isCertain && leadsToRecord(at, length)) {
        return new Found(at, opcode, length, false);
      }
      if (isCertain && isCutChunk(opcode, at, length, ofFields)) {
        return new Found(at, opcode, end - at - Opcode.PREFIX, true);
      }
    }
    return null;
  }
}
