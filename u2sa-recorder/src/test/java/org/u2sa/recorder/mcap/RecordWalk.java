package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.nio.channels.SeekableByteChannel;
import java.util.Collections;
import java.util.Iterator;
import org.u2sa.recorder.mcap.record.Opcode;

/**
 * Iterates over all records of a complete file, from header to footer. Chunks are replaced by their
 * records; message indexes are skipped.
 */
final class RecordWalk {
  private final RecordStream stream;
  private Iterator<RecordStream.Entry> ofChunk = Collections.emptyIterator();
  private boolean ended;

  RecordWalk(SeekableByteChannel file) throws IOException {
    RecordStream.requireMagic(file, 0);
    stream = new RecordStream(file, Opcode.magic().length);
  }

  /** Next record; null after the footer. */
  RecordStream.Entry next() throws IOException {
    while (!ofChunk.hasNext()) {
      if (ended) {
        return null;
      }
      RecordStream.Entry entry = stream.next();
      if (entry.opcode() == Opcode.CHUNK) {
        ofChunk = ChunkContent.read(entry.fields()).records().iterator();
      } else if (entry.opcode() != Opcode.MESSAGE_INDEX) {
        ended = entry.opcode() == Opcode.FOOTER;
        return entry;
      }
    }
    return ofChunk.next();
  }
}
