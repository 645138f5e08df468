package org.u2sa.recorder.mcap.record;

import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.zip.CRC32;

/** Reads the fields of a record in order. Bytes after the last known field are ignored. */
public final class RecordFields {
  private final byte[] content;
  private final int from;
  private final ByteBuffer bytes;
  private final Buffer place; // alias: Android 28 has position(int) in Buffer only

  /** Reads all of an array. */
  public RecordFields(byte[] content) {
    this(content, 0, content.length);
  }

  /** Reads part of an array. */
  public RecordFields(byte[] content, int from, int length) {
    this.content = content;
    this.from = from;
    bytes = ByteBuffer.wrap(content, from, length).order(ByteOrder.LITTLE_ENDIAN);
    place = bytes;
  }

  /** Reads one byte. */
  public int uint8() throws McapException {
    require(1);
    return bytes.get() & 0xFF;
  }

  /** Reads an unsigned 16-bit integer. */
  public int uint16() throws McapException {
    require(Short.BYTES);
    return bytes.getShort() & 0xFFFF;
  }

  /** Reads an unsigned 32-bit integer. */
  public long uint32() throws McapException {
    require(Integer.BYTES);
    return bytes.getInt() & 0xFFFF_FFFFL;
  }

  /** Reads an unsigned 64-bit integer. */
  public long uint64() throws McapException {
    require(Long.BYTES);
    return bytes.getLong();
  }

  /** Reads a UTF-8 string with its length. */
  public String string() throws McapException {
    return new String(bytes(uint32()), StandardCharsets.UTF_8);
  }

  /** Reads this many bytes. */
  public byte[] bytes(long length) throws McapException {
    require(length);
    byte[] value = new byte[(int) length];
    bytes.get(value);
    return value;
  }

  Map<String, String> map() throws McapException {
    RecordFields entries = part();
    Map<String, String> map = new LinkedHashMap<>();
    while (entries.remaining() > 0) {
      map.put(entries.string(), entries.string());
    }
    return map;
  }

  /** A map or array with a length prefix. */
  RecordFields part() throws McapException {
    long length = uint32();
    require(length);
    RecordFields part = new RecordFields(content, bytes.position(), (int) length);
    place.position(bytes.position() + (int) length);
    return part;
  }

  CRC32 crcSoFar() {
    CRC32 crc = new CRC32();
    crc.update(content, from, bytes.position() - from);
    return crc;
  }

  /** Number of bytes not yet read. */
  public int remaining() {
    return bytes.remaining();
  }

  /** Offset of the next field in the array. */
  public int position() {
    return bytes.position();
  }

  /** Skips this many bytes. */
  public void skip(long length) throws McapException {
    require(length);
    place.position(bytes.position() + (int) length);
  }

  private void require(long length) throws McapException {
    if (length < 0 || length > bytes.remaining()) {
      throw new McapException(
          "a field of "
              + length
              + " bytes, but its record has only "
              + bytes.remaining()
              + " more");
    }
  }
}
