package org.u2sa.gcs.mavlink.file;

import java.io.IOException;
import java.util.Arrays;

/** Content that stations can download. */
interface ReadableFile {
  /** Number of bytes; stays the same even if a recording grows. */
  long size();

  /**
   * Reads bytes.
   *
   * @param offset from the beginning, at most {@link #size()}
   * @param length number of bytes; fewer are returned at the end
   * @throws IOException if the disk fails or the file is gone
   */
  byte[] read(long offset, int length) throws IOException;

  /** A file whose content is in memory. */
  static ReadableFile of(byte[] content) {
    return new ReadableFile() {
      @Override
      public long size() {
        return content.length;
      }

      @Override
      public byte[] read(long offset, int length) {
        int from = (int) Math.min(offset, content.length);
        return Arrays.copyOfRange(content, from, (int) Math.min(content.length, offset + length));
      }
    };
  }
}
