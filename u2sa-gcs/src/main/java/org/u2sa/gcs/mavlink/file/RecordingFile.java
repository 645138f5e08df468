package org.u2sa.gcs.mavlink.file;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;

/**
 * A recording, with the size it had when opened. Reads blocks and holds no file open between them,
 * so a station that disappears leaves nothing to close.
 */
final class RecordingFile implements ReadableFile {
  private static final int BLOCK = 64 * 1024;

  private final Path file;
  private final long size;
  private final RecordingDisk disk;
  private byte[] block = new byte[0];
  private long blockAt;

  RecordingFile(Path file, long size, RecordingDisk disk) {
    this.file = file;
    this.size = size;
    this.disk = disk;
  }

  @Override
  public long size() {
    return size;
  }

  @Override
  public byte[] read(long offset, int length) throws IOException {
    int wanted = (int) Math.max(0, Math.min(length, size - offset));
    if (wanted == 0) {
      return new byte[0];
    }
    if (offset < blockAt || offset + wanted > blockAt + block.length) {
      int much = (int) Math.min(Math.max(BLOCK, wanted), size - offset);
      block = disk.answer(() -> load(offset, much));
      blockAt = offset;
    }
    int from = (int) (offset - blockAt);
    return Arrays.copyOfRange(block, from, from + wanted);
  }

  private byte[] load(long offset, int length) throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate(length);
    try (SeekableByteChannel channel =
        Files.newByteChannel(file, StandardOpenOption.READ, LinkOption.NOFOLLOW_LINKS)) {
      channel.position(offset);
      while (buffer.hasRemaining()) {
        if (channel.read(buffer) < 0) {
          throw new EOFException(file + " has become shorter");
        }
      }
    }
    return buffer.array();
  }
}
