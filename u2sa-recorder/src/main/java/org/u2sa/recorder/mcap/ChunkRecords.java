package org.u2sa.recorder.mcap;

import java.util.Arrays;
import java.util.Iterator;
import java.util.NoSuchElementException;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.RecordFields;

/**
 * Records of a decompressed chunk, up to the first error. Iterates in place and creates each record
 * on demand, since a chunk can hold millions.
 */
final class ChunkRecords implements Iterable<RecordStream.Entry> {
  private final byte[] bytes;
  private final int end; // of the last complete record [B]
  private final McapException trouble; // null if none

  ChunkRecords(byte[] bytes) {
    this.bytes = bytes;
    RecordFields in = new RecordFields(bytes);
    int whole = 0;
    McapException wrong = null;
    try {
      while (in.remaining() > 0) {
        in.uint8();
        in.skip(in.uint64());
        whole = in.position();
      }
    } catch (McapException e) {
      wrong = e;
    }
    end = whole;
    trouble = wrong;
  }

  /** Error that ended the records early; null if none. */
  McapException trouble() {
    return trouble;
  }

  @Override
  public Iterator<RecordStream.Entry> iterator() {
    return new Walk();
  }

  private final class Walk implements Iterator<RecordStream.Entry> {
    private final RecordFields in = new RecordFields(bytes, 0, end);

    @Override
    public boolean hasNext() {
      return in.remaining() > 0;
    }

    @Override
    public RecordStream.Entry next() {
      if (!hasNext()) {
        throw new NoSuchElementException("the chunk has no more records");
      }
      try {
        int offset = in.position();
        int opcode = in.uint8();
        long length = in.uint64();
        int from = in.position();
        in.skip(length);
        return new RecordStream.Entry(
            offset, opcode, Arrays.copyOfRange(bytes, from, in.position()));
      } catch (McapException e) {
        throw new IllegalStateException("a record that was complete no longer is", e);
      }
    }
  }
}
