package org.u2sa.recorder.mcap;

import java.io.EOFException;
import java.io.IOException;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.util.Arrays;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/** Reads the records of a file sequentially from an offset. */
final class RecordStream {
  private final SeekableByteChannel file;
  private final long size;
  private long position;

  /** A record: file offset [B], opcode, and content without opcode and length. */
  record Entry(long offset, int opcode, byte[] content) {
    RecordFields fields() {
      return new RecordFields(content);
    }

    long length() {
      return Opcode.PREFIX + (long) content.length;
    }
  }

  RecordStream(SeekableByteChannel file, long from) throws IOException {
    this.file = file;
    size = file.size();
    position = from;
  }

  /** Requires the bytes that mark MCAP at an offset. */
  static void requireMagic(SeekableByteChannel file, long at) throws IOException {
    ByteBuffer magic = ByteBuffer.allocate(Opcode.magic().length);
    if (at < 0 || file.size() < at + magic.capacity()) {
      throw new McapException("the file has " + file.size() + " bytes: too few for MCAP");
    }
    file.position(at);
    while (magic.hasRemaining() && file.read(magic) >= 0) {
      continue; // a channel may return a part
    }
    if (!Arrays.equals(magic.array(), Opcode.magic())) {
      throw new McapException("at byte " + at + " the bytes do not mark MCAP version 0");
    }
  }

  /** File offset of the next record [B]. */
  long position() {
    return position;
  }

  /** Opcode and content length of the next record; null at the end of the file. */
  long[] peek() throws IOException {
    if (size - position < Opcode.PREFIX) {
      return null;
    }
    ByteBuffer prefix = read(position, Opcode.PREFIX);
    return new long[] {prefix.get() & 0xFF, prefix.getLong()};
  }

  /**
   * The next record.
   *
   * @throws EOFException if the file ends within the record
   * @throws McapException if it is not a valid record
   */
  Entry next() throws IOException {
    long[] prefix = peek();
    if (prefix == null) {
      throw new EOFException("the file breaks off at byte " + size);
    }
    long length = prefix[1];
    if (prefix[0] == 0 || length < 0 || length > ReadLimits.MAX_LENGTH) {
      throw new McapException(
          "at byte " + position + ": no valid record: opcode " + prefix[0] + ", length " + length);
    }
    if (length > size - position - Opcode.PREFIX) {
      throw new EOFException("the file breaks off at byte " + size + ", within a record");
    }
    Entry entry =
        new Entry(position, (int) prefix[0], read(position + Opcode.PREFIX, (int) length).array());
    position += entry.length();
    return entry;
  }

  /**
   * Next bytes.
   *
   * @throws McapException if they exceed the size limit
   */
  byte[] bytes(long length) throws IOException {
    if (length > ReadLimits.MAX_LENGTH) {
      throw new McapException(
          "a record of "
              + length
              + " bytes: expected at most "
              + ReadLimits.MAX_LENGTH
              + " to be read at once");
    }
    if (length > size - position) {
      throw new EOFException("the file breaks off at byte " + size + ", within a record");
    }
    return read(position, (int) length).array();
  }

  private ByteBuffer read(long from, int length) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(length).order(ByteOrder.LITTLE_ENDIAN);
    file.position(from);
    while (bytes.hasRemaining()) {
      if (file.read(bytes) < 0) {
        throw new EOFException("the file became shorter while it was read");
      }
    }
    Buffer place = bytes; // Android 28 has rewind() in Buffer only
    place.rewind();
    return bytes;
  }
}
