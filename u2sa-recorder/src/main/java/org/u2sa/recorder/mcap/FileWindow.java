package org.u2sa.recorder.mcap;

import java.io.EOFException;
import java.io.IOException;
import java.nio.Buffer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.SeekableByteChannel;
import java.util.zip.CRC32;

/**
 * Buffered random access to numbers in a file, fast enough to search every byte. Not thread-safe.
 */
final class FileWindow {
  private static final int CAPACITY = 1 << 16;

  private final SeekableByteChannel file;
  private final long size;
  private final ByteBuffer bytes = ByteBuffer.allocate(CAPACITY).order(ByteOrder.LITTLE_ENDIAN);
  private final Buffer place = bytes; // alias: Android 28 has clear() and flip() in Buffer only
  private long from; // offset of the buffer's first byte in the file

  FileWindow(SeekableByteChannel file) throws IOException {
    this.file = file;
    size = file.size();
    place.limit(0);
  }

  /** Length of the file [B]. */
  long size() {
    return size;
  }

  int uint8(long at) throws IOException {
    return bytes.get(index(at, 1)) & 0xFF;
  }

  long uint32(long at) throws IOException {
    return bytes.getInt(index(at, Integer.BYTES)) & 0xFFFF_FFFFL;
  }

  long uint64(long at) throws IOException {
    return bytes.getLong(index(at, Long.BYTES));
  }

  private int index(long at, int length) throws IOException {
    if (at < from || at + length > from + place.limit()) {
      load(at, length);
    }
    return (int) (at - from);
  }

  private void load(long at, int length) throws IOException {
    from = at;
    place.clear();
    file.position(at);
    while (bytes.hasRemaining() && file.read(bytes) >= 0) {
      continue; // a channel may return a part
    }
    place.flip();
    if (place.limit() < length) {
      throw new EOFException("the file breaks off at byte " + (at + place.limit()));
    }
  }

  /** Checksum of a range of the file; the caller ensures that it is within the file. */
  long crc(long begin, long end) throws IOException {
    CRC32 crc = new CRC32();
    for (long at = begin; at < end; at += CAPACITY) {
      load(at, 1);
      crc.update(bytes.array(), 0, (int) Math.min(place.limit(), end - at));
    }
    return crc.getValue();
  }
}
