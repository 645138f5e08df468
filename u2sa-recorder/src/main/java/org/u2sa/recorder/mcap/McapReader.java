package org.u2sa.recorder.mcap;

import java.io.EOFException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.u2sa.recorder.mcap.record.AttachmentIndex;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.McapStatistics;
import org.u2sa.recorder.mcap.record.MetadataIndex;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/**
 * Reads a complete MCAP file with a summary: its contents are known on opening, messages are read
 * on demand. Not thread-safe.
 */
public final class McapReader implements AutoCloseable {
  private static final int FOOTER_LENGTH = Opcode.PREFIX + 8 + 8 + 4;

  private final Path path;
  private final FileChannel file;
  private final Map<Integer, McapSchema> schemas = new TreeMap<>();
  private final Map<Integer, McapChannel> channels = new TreeMap<>();
  // View for callers; requested with each message, so nothing is copied.
  private final Map<Integer, McapSchema> schemasSeen = Collections.unmodifiableMap(schemas);
  private final Map<Integer, McapChannel> channelsSeen = Collections.unmodifiableMap(channels);
  private final List<ChunkIndex> chunks = new ArrayList<>();
  private final List<AttachmentIndex> attachments = new ArrayList<>();
  private final List<MetadataIndex> metadata = new ArrayList<>();
  private McapStatistics statistics;
  private boolean isMarked; // at its beginning, as an MCAP file

  private McapReader(Path path, FileChannel file) {
    this.path = path;
    this.file = file;
  }

  /**
   * Opens a file.
   *
   * @throws McapException if it is not an MCAP file, is incomplete or has no summary; such a file
   *     may be recoverable
   * @throws IOException if it cannot be read
   */
  public static McapReader open(Path path) throws IOException {
    FileChannel file = FileChannel.open(path, StandardOpenOption.READ);
    McapReader reader = new McapReader(path, file);
    try {
      reader.readSummary();
      return reader;
    } catch (EOFException | McapException e) {
      file.close();
      String remedy =
          reader.isMarked ? "recover it first" : "expected an MCAP file; recover it if it was one";
      throw new McapException(path + ": " + e.getMessage() + "; " + remedy, e);
    } catch (IOException | RuntimeException e) {
      file.close();
      throw e;
    }
  }

  private void readSummary() throws IOException {
    RecordStream.requireMagic(file, 0);
    isMarked = true;
    long endMagic = file.size() - Opcode.magic().length;
    RecordStream.requireMagic(file, endMagic);
    if (endMagic < Opcode.magic().length + FOOTER_LENGTH) {
      throw new McapException("the file has " + file.size() + " bytes: too few for an MCAP footer");
    }
    RecordStream.Entry footer = new RecordStream(file, endMagic - FOOTER_LENGTH).next();
    if (footer.opcode() != Opcode.FOOTER) {
      throw new McapException("the file does not end with a footer");
    }
    long start = footer.fields().uint64();
    if (start <= 0 || start >= footer.offset()) {
      throw new McapException("the file has no summary");
    }
    RecordStream stream = new RecordStream(file, start);
    for (RecordStream.Entry e = stream.next(); e.opcode() != Opcode.FOOTER; e = stream.next()) {
      take(e);
    }
    if (statistics == null) {
      throw new McapException("the file's summary has no statistics");
    }
    if (statistics.startNanos() < 0 || statistics.endNanos() < statistics.startNanos()) {
      throw new McapException(
          String.format(
              "log times from %s to %s ns; expected ascending ones below 2^63",
              Long.toUnsignedString(statistics.startNanos()),
              Long.toUnsignedString(statistics.endNanos())));
    }
    if (statistics.chunks() != chunks.size() || statistics.messages() > 0 && chunks.isEmpty()) {
      throw new McapException("the file's summary lacks the positions of its messages");
    }
    IndexedPlaces places = new IndexedPlaces();
    chunks.forEach(chunk -> places.add(chunk.offset(), chunk.length()));
    attachments.forEach(attachment -> places.add(attachment.offset(), attachment.length()));
    metadata.forEach(one -> places.add(one.offset(), one.length()));
    places.require(start);
  }

  private void take(RecordStream.Entry entry) throws McapException {
    RecordFields in = entry.fields();
    switch (entry.opcode()) {
      case Opcode.SCHEMA -> {
        McapSchema schema = McapSchema.read(in);
        schemas.put(schema.id(), schema);
      }
      case Opcode.CHANNEL -> {
        McapChannel channel = McapChannel.read(in);
        channels.put(channel.id(), channel);
      }
      case Opcode.STATISTICS -> statistics = McapStatistics.read(in);
      case Opcode.CHUNK_INDEX -> chunks.add(ChunkIndex.read(in));
      case Opcode.ATTACHMENT_INDEX -> attachments.add(AttachmentIndex.read(in));
      case Opcode.METADATA_INDEX -> metadata.add(MetadataIndex.read(in));
      default -> {
        // summary offsets: not needed, the whole summary is read
      }
    }
  }

  /** All schemas by ID. */
  public Map<Integer, McapSchema> schemas() {
    return schemasSeen;
  }

  /** All channels by ID. */
  public Map<Integer, McapChannel> channels() {
    return channelsSeen;
  }

  /** Statistics of the file. */
  public McapStatistics statistics() {
    return statistics;
  }

  /** Attachment names, in file order. */
  public List<String> attachmentNames() {
    return attachments.stream().map(AttachmentIndex::name).collect(Collectors.toList());
  }

  /** First attachment with this name. */
  public Optional<McapAttachment> attachment(String name) throws IOException {
    for (AttachmentIndex index : attachments) {
      if (index.name().equals(name)) {
        return Optional.of(
            read(index.offset(), index.length(), Opcode.ATTACHMENT, McapAttachment::read));
      }
    }
    return Optional.empty();
  }

  /** All metadata, in file order. */
  public List<McapMetadata> metadata() throws IOException {
    List<McapMetadata> all = new ArrayList<>();
    for (MetadataIndex index : metadata) {
      all.add(read(index.offset(), index.length(), Opcode.METADATA, McapMetadata::read));
    }
    return all;
  }

  private interface Parser<T> {
    T read(RecordFields in) throws McapException;
  }

  private <T> T read(long offset, long length, int opcode, Parser<T> parser) throws IOException {
    try {
      return parser.read(at(offset, length, opcode));
    } catch (EOFException | McapException e) {
      throw new McapException(
          String.format(
              "%s: the record at byte %d is damaged: %s; recover the file first",
              path, offset, e.getMessage()),
          e);
    }
  }

  private RecordFields at(long offset, long length, int opcode) throws IOException {
    RecordStream.Entry entry = new RecordStream(file, offset).next();
    if (entry.opcode() != opcode || entry.length() != length) {
      throw new McapException(
          String.format(
              "it is of kind %d, with %d bytes; expected kind %d, %d bytes",
              entry.opcode(), entry.length(), opcode, length));
    }
    return entry.fields();
  }

  /**
   * Messages in log-time order; equal times in file order. Holds one chunk at a time unless chunks
   * overlap.
   *
   * @param fromNanos earliest log time wanted [ns]
   * @param wanted selects the channels
   */
  public McapCursor messages(long fromNanos, Predicate<McapChannel> wanted) {
    BitSet ids = new BitSet();
    channels.values().stream().filter(wanted).forEach(channel -> ids.set(channel.id()));
    return new McapCursor(
        path.toString(),
        chunks,
        fromNanos,
        ids,
        index ->
            ChunkContent.read(at(index.offset(), index.length(), Opcode.CHUNK))
                .decompressed(index.size()),
        ReadLimits.heldBytes());
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
