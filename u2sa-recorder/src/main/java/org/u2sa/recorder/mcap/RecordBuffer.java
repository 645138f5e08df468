package org.u2sa.recorder.mcap;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.zip.CRC32;

/** Records on their way into a file: bytes in little-endian order that grow as needed. */
final class RecordBuffer {
  private static final byte[] LATER = {0x01, (byte) 0xFF, (byte) 0xFF};

  private final boolean laterFields;
  private ByteBuffer bytes;
  private int start; // of the present record's content

  /**
   * @param laterFields whether bytes follow a record's last field
   */
  RecordBuffer(int capacity, boolean laterFields) {
    bytes = ByteBuffer.allocate(capacity).order(ByteOrder.LITTLE_ENDIAN);
    this.laterFields = laterFields;
  }

  RecordBuffer begin(int opcode) {
    room(Opcode.PREFIX);
    bytes.put((byte) opcode).putLong(0);
    start = bytes.position();
    return this;
  }

  /** Ends a record to whose kind fields may be added one day. */
  void end() {
    if (laterFields) {
      bytes(LATER, 0, LATER.length);
    }
    endAsIs();
  }

  /** Ends a record whose kind will never have more fields. */
  void endAsIs() {
    bytes.putLong(start - Long.BYTES, bytes.position() - start);
  }

  RecordBuffer uint8(int value) {
    room(1);
    bytes.put((byte) value);
    return this;
  }

  RecordBuffer uint16(int value) {
    room(Short.BYTES);
    bytes.putShort((short) value);
    return this;
  }

  RecordBuffer uint32(long value) {
    room(Integer.BYTES);
    bytes.putInt((int) value);
    return this;
  }

  RecordBuffer uint64(long value) {
    room(Long.BYTES);
    bytes.putLong(value);
    return this;
  }

  RecordBuffer string(String value) {
    byte[] text = value.getBytes(StandardCharsets.UTF_8);
    return uint32(text.length).bytes(text, 0, text.length);
  }

  RecordBuffer map(Map<String, String> entries) {
    int length = beginLength();
    entries.forEach((key, value) -> string(key).string(value));
    endLength(length);
    return this;
  }

  /** Leaves room for the length of what follows; to be handed to {@link #endLength}. */
  int beginLength() {
    uint32(0);
    return bytes.position();
  }

  void endLength(int from) {
    bytes.putInt(from - Integer.BYTES, bytes.position() - from);
  }

  RecordBuffer bytes(byte[] data, int offset, int length) {
    room(length);
    bytes.put(data, offset, length);
    return this;
  }

  /** Writes into an array from some place on, and returns where it ended. */
  @FunctionalInterface
  interface Filler {
    int fill(byte[] array, int from);
  }

  /** Adds what the filler writes, at most so many bytes. */
  RecordBuffer fill(int atMost, Filler filler) {
    room(atMost);
    place(bytes).position(filler.fill(bytes.array(), bytes.position()));
    return this;
  }

  /** Leaves room for the 64-bit length of what follows; to be handed to {@link #endLongLength}. */
  int beginLongLength() {
    uint64(0);
    return bytes.position();
  }

  /** Returns that length. */
  int endLongLength(int from) {
    int length = bytes.position() - from;
    bytes.putLong(from - Long.BYTES, length);
    return length;
  }

  /** Of all that the present record holds so far. */
  long crcOfContent() {
    CRC32 crc = new CRC32();
    crc.update(bytes.array(), start, bytes.position() - start);
    return crc.getValue();
  }

  int length() {
    return bytes.position();
  }

  /** What was written, from the beginning to {@link #length}. */
  byte[] array() {
    return bytes.array();
  }

  void clear() {
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
