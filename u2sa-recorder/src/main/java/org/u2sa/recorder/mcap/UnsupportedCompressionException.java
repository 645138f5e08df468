package org.u2sa.recorder.mcap;

import java.io.IOException;

/** Thrown for a sound chunk in a compression of the specification that is not supported. */
final class UnsupportedCompressionException extends IOException {
  private static final long serialVersionUID = 1L;

  UnsupportedCompressionException(String compression) {
    super(
        "chunks are compressed with "
            + compression
            + ", which is not supported; convert the file first: mcap compress --compression lz4 "
            + "FILE --output NEW-FILE");
  }
}
