package org.u2sa.recorder.mcap.record;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.zip.CRC32;

/** Growable little-endian buffer for records to be written. */
public final class RecordBuffer {
  private static final byte[] LATER = {0x01, (byte) 0xFF, (byte) 0xFF};

  private final boolean laterFields;
  private ByteBuffer bytes;
  private int start; // of the current record's content

  /**
   * @param laterFields whether to append extra bytes after a record's last field
   */
  public RecordBuffer(int capacity, boolean laterFields) {
    bytes = ByteBuffer.allocate(capacity).order(ByteOrder.LITTLE_ENDIAN);
    this.laterFields = laterFields;
  }

  /** Begins a record with an opcode; end writes its length. */
  public RecordBuffer begin(int opcode) {
    room(Opcode.PREFIX);
    bytes.put((byte) opcode).putLong(0);
    start = bytes.position();
    return this;
  }

  /** Ends a record of an extensible type. */
  public void end() {
    if (laterFields) {
      bytes(LATER, 0, LATER.length);
    }
    endAsIs();
  }

  /** Ends a record of a type that is not extensible. */
  public void endAsIs() {
    bytes.putLong(start - Long.BYTES, bytes.position() - start);
  }

  /** Appends one byte. */
  public RecordBuffer uint8(int value) {
    room(1);
    bytes.put((byte) value);
    return this;
  }

  /** Appends an unsigned 16-bit integer. */
  public RecordBuffer uint16(int value) {
    room(Short.BYTES);
    bytes.putShort((short) value);
    return this;
  }

  /** Appends an unsigned 32-bit integer. */
  public RecordBuffer uint32(long value) {
    room(Integer.BYTES);
    bytes.putInt((int) value);
    return this;
  }

  /** Appends an unsigned 64-bit integer. */
  public RecordBuffer uint64(long value) {
    room(Long.BYTES);
    bytes.putLong(value);
    return this;
  }

  /** Appends a UTF-8 string with its length. */
  public RecordBuffer string(String value) {
    byte[] text = value.getBytes(StandardCharsets.UTF_8);
    return uint32(text.length).bytes(text, 0, text.length);
  }

  RecordBuffer map(Map<String, String> entries) {
    int length = beginLength();
    entries.forEach((key, value) -> string(key).string(value));
    endLength(length);
    return this;
  }

  /** Reserves a length field; returns its position for {@link #endLength}. */
  public int beginLength() {
    uint32(0);
    return bytes.position();
  }

  /** Writes the 32-bit length of everything since that position. */
  public void endLength(int from) {
    bytes.putInt(from - Integer.BYTES, bytes.position() - from);
  }

  /** Appends part of an array. */
  public RecordBuffer bytes(byte[] data, int offset, int length) {
    room(length);
    bytes.put(data, offset, length);
    return this;
  }

  /** Writes into an array from an offset, and returns the end offset. */
  @FunctionalInterface
  public interface Filler {
    int fill(byte[] array, int from);
  }

  /** Appends the filler's output, at most this many bytes. */
  public RecordBuffer fill(int atMost, Filler filler) {
    room(atMost);
    place(bytes).position(filler.fill(bytes.array(), bytes.position()));
    return this;
  }

  /** Reserves a 64-bit length field; returns its position for {@link #endLongLength}. */
  public int beginLongLength() {
    uint64(0);
    return bytes.position();
  }

  /** Fills in the length and returns it. */
  public int endLongLength(int from) {
    int length = bytes.position() - from;
    bytes.putLong(from - Long.BYTES, length);
    return length;
  }

  /** Checksum of the current record so far. */
  long crcOfContent() {
    CRC32 crc = new CRC32();
    crc.update(bytes.array(), start, bytes.position() - start);
    return crc.getValue();
  }

  /** Number of bytes in the buffer. */
  public int length() {
    return bytes.position();
  }

  /** Backing array; valid up to {@link #length}. */
  public byte[] array() {
    return bytes.array();
  }

  /** Removes all bytes. */
  public void clear() {
    place(bytes).clear();
  }

  /** Android 28 has these methods in Buffer only. */
  private static Buffer place(ByteBuffer buffer) {
    return buffer;
  }

  private void room(int more) {
    if (bytes.remaining() < more) {
      long needed = (long) bytes.position() + more;
      long larger = Math.min(Integer.MAX_VALUE - 8L, Math.max(2L * bytes.capacity(), needed));
      if (needed > larger) {
        throw new IllegalArgumentException("a record of " + needed + " bytes is too long");
      }
      ByteBuffer grown = ByteBuffer.allocate((int) larger).order(ByteOrder.LITTLE_ENDIAN);
      place(bytes).flip();
      bytes = grown.put(bytes);
    }
  }
}
