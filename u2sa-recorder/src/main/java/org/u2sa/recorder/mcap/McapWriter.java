package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SeekableByteChannel;
import java.util.zip.CRC32;
import org.u2sa.recorder.mcap.record.AttachmentIndex;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.MetadataIndex;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordBuffer;

/**
 * Writes one MCAP file sequentially. Not thread-safe.
 *
 * <p>At any time the file consists of complete records, as far as the file system preserves writes:
 * a chunk and its indexes are written together, and a partial write, e.g. on a full disk, is
 * truncated again. Its messages are counted in {@link #lost}, and the next chunk repeats its
 * definitions.
 */
public final class McapWriter implements AutoCloseable {
  private static final int FIRST_CAPACITY = 1 << 12;

  private final SeekableByteChannel file;
  private final McapOptions options;
  private final RecordBuffer out;
  private final ChunkBuilder chunk; // null: messages are written immediately
  private final Summary summary = new Summary();
  private final CRC32 dataCrc = new CRC32();
  private long position;
  private long lost;
  private boolean closed;

  /**
   * Starts a file.
   *
   * @param file destination; must be empty; closed by {@link #close}
   * @throws IOException if it cannot be written
   */
  public McapWriter(SeekableByteChannel file, McapOptions options) throws IOException {
    this.file = file;
    this.options = options;
    out = new RecordBuffer(FIRST_CAPACITY, options.has(McapFeature.LATER_FIELDS));
    chunk = options.has(McapFeature.CHUNKS) ? new ChunkBuilder(options) : null;
    byte[] magic = Opcode.magic();
    out.bytes(magic, 0, magic.length);
    out.begin(Opcode.HEADER).string(options.profile()).string(options.library()).end();
    write();
  }

  /**
   * Defines a schema; call before defining a channel that uses it.
   *
   * @throws IOException if it cannot be written
   */
  public void add(McapSchema schema) throws IOException {
    if (chunk != null) {
      chunk.add(schema);
    } else {
      schema.write(out);
      write();
      summary.add(schema);
    }
  }

  /**
   * Defines a channel; call before adding its first message.
   *
   * @throws IOException if it cannot be written
   */
  public void add(McapChannel channel) throws IOException {
    if (chunk != null) {
      chunk.add(channel);
    } else {
      channel.write(out);
      write();
      summary.add(channel);
    }
  }

  /**
   * Adds a message, after writing the current chunk if full.
   *
   * @throws IOException if the chunk cannot be written; the message itself is still added
   */
  public void add(McapMessage message) throws IOException {
    if (chunk == null) {
      message.write(out);
      write();
      summary.add(message);
      return;
    }
    try {
      if (chunk.isDone(message.logTimeNanos())) {
        flush();
      }
    } finally {
      chunk.add(message);
    }
  }

  /**
   * Adds an attachment; not part of any chunk.
   *
   * @throws IOException if it cannot be written
   */
  public void add(McapAttachment attachment) throws IOException {
    attachment.write(out);
    long at = position;
    write();
    summary.add(
        new AttachmentIndex(
            at,
            position - at,
            attachment.logTimeNanos(),
            attachment.createTimeNanos(),
            attachment.data().length,
            attachment.name(),
            attachment.mediaType()));
  }

  /**
   * Adds metadata; not part of any chunk.
   *
   * @throws IOException if they cannot be written
   */
  public void add(McapMetadata metadata) throws IOException {
    metadata.write(out);
    long at = position;
    write();
    summary.add(new MetadataIndex(at, position - at, metadata.name()));
  }

  /**
   * Writes the current chunk, if not empty.
   *
   * @throws IOException if it cannot be written; its messages are then lost
   */
  public void flush() throws IOException {
    if (chunk == null || chunk.isEmpty()) {
      return;
    }
    ChunkIndex index;
    try {
      index = chunk.write(out, position);
      write();
    } catch (IOException e) {
      out.clear();
      lost += chunk.count().messages();
      chunk.dropMessages();
      throw e;
    }
    chunk.schemas().forEach(summary::add);
    chunk.channels().forEach(summary::add);
    summary.add(chunk.count());
    summary.add(index);
    chunk.next();
  }

  /** File length without the current chunk [B]. */
  public long position() {
    return position;
  }

  /** Number of accepted messages that could not be written. */
  public long lost() {
    return lost;
  }

  /** Statistics of the file without the current chunk. */
  public McapStatistics statistics() {
    return summary.statistics();
  }

  /**
   * Completes the file with its summary. Idempotent.
   *
   * @throws IOException if it cannot be written; the file then ends after its last complete record,
   *     without a summary
   */
  @Override
  public void close() throws IOException {
    if (closed) {
      return;
    }
    closed = true;
    try {
      flush();
    } finally {
      try {
        writeEnd();
      } finally {
        file.close();
      }
    }
  }

  private void writeEnd() throws IOException {
    out.begin(Opcode.DATA_END).uint32(dataCrc.getValue()).endAsIs();
    int dataEnd = out.length();
    RecordBuffer end = new RecordBuffer(FIRST_CAPACITY, options.has(McapFeature.LATER_FIELDS));
    summary.write(end, position + dataEnd, options);
    byte[] magic = Opcode.magic();
    out.bytes(end.array(), 0, end.length()).bytes(magic, 0, magic.length);
    write();
  }

  private void write() throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(out.array(), 0, out.length());
    int length = out.length();
    out.clear();
    try {
      while (bytes.hasRemaining()) {
        file.write(bytes);
      }
    } catch (IOException e) {
      cutOff(e);
      throw e;
    }
    dataCrc.update(bytes.array(), 0, length);
    position += length;
  }

  private void cutOff(IOException cause) {
    try {
      file.truncate(position);
      file.position(position);
    } catch (IOException e) {
      cause.addSuppressed(e);
    }
  }
}
