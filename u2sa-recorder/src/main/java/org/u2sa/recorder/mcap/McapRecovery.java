package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.u2sa.recorder.mcap.record.McapAttachment;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapMetadata;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/**
 * Recovers a truncated or damaged file. Drops chunks with a wrong checksum, since any of their
 * messages may be corrupt; keeps all others. Not thread-safe.
 */
public final class McapRecovery {
  private final FileChannel from;
  private final McapWriter writer;
  private final long maxBytes; // of a record or a decompressed chunk
  private final Definitions definitions = new Definitions();
  private final Set<Integer> schemas = new HashSet<>(); // written
  private final Set<Integer> channels = new HashSet<>(); // written
  private long messages;
  private int damagedChunks;
  private String trouble;

  /**
   * Result of a recovery.
   *
   * @param messages number of messages recovered
   * @param damagedChunks number of chunks dropped
   * @param trouble faults of the file, in order of discovery; empty if none
   */
  public record Result(long messages, int damagedChunks, Optional<String> trouble) {}

  private McapRecovery(FileChannel from, McapWriter writer, long maxBytes) {
    this.from = from;
    this.writer = writer;
    this.maxBytes = maxBytes;
  }

  /**
   * Copies everything readable.
   *
   * @param broken damaged file; not modified
   * @param whole new file; must not exist
   * @param library writing library, for the new file's header
   * @throws IOException if reading or writing fails, or the compression is not supported; then
   *     there is no new file
   */
  public static Result recover(Path broken, Path whole, String library) throws IOException {
    return recover(broken, whole, library, ReadLimits.heldBytes());
  }

  /** Same, with a size limit for records and decompressed chunks; larger ones are dropped. */
  static Result recover(Path broken, Path whole, String library, long maxBytes) throws IOException {
    try (FileChannel from = FileChannel.open(broken, StandardOpenOption.READ);
        FileChannel to =
            FileChannel.open(whole, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        McapWriter writer = new McapWriter(to, McapOptions.usual(ChunkCompression.LZ4, library))) {
      McapRecovery recovery = new McapRecovery(from, writer, maxBytes);
      recovery.copy();
      return new Result(
          recovery.messages, recovery.damagedChunks, Optional.ofNullable(recovery.trouble));
    } catch (UnsupportedCompressionException e) {
      Files.delete(whole);
      throw new McapException(broken + ": " + e.getMessage(), e);
    }
  }

  private void copy() throws IOException {
    FileOutline outline = FileOutline.of(from, definitions, this::note);
    RecordSearch search = new RecordSearch(from, known -> {}); // reported by the outline
    for (RecordSearch.Found f = search.next(); f != null; f = search.next()) {
      try {
        copy(f);
      } catch (McapException e) {
        note(e.getMessage());
      }
    }
    for (McapChannel channel : definitions.reliableChannels()) {
      define(channel);
    }
    if (outline.messages().isPresent() && outline.messages().getAsLong() != messages) {
      note(messages + " of its " + outline.messages().getAsLong() + " messages can be read");
    } else if (trouble == null) {
      outline.checkData(this::note);
    }
    if (trouble != null) {
      Map<String, String> facts = new LinkedHashMap<>();
      facts.put("trouble", trouble);
      facts.put("bytes", Long.toString(from.size()));
      facts.put("messages", Long.toString(messages));
      facts.put("damaged-chunks", Integer.toString(damagedChunks));
      writer.add(new McapMetadata("recovery", facts));
    }
  }

  private void copy(RecordSearch.Found found) throws IOException {
    switch (found.opcode()) {
      case Opcode.CHUNK -> copyChunk(found);
      case Opcode.MESSAGE -> copy(McapMessage.read(content(found)));
      case Opcode.ATTACHMENT -> writer.add(McapAttachment.read(content(found)));
      case Opcode.METADATA -> writer.add(McapMetadata.read(content(found)));
      default -> {
        // header, indexes and summary are created for the new file
      }
    }
  }

  private RecordFields content(RecordSearch.Found found) throws IOException {
    requireHeld("the record at byte " + found.offset(), found.length());
    return new RecordFields(new RecordStream(from, found.contentAt()).bytes(found.length()));
  }

  private void requireHeld(String what, long bytes) throws McapException {
    if (bytes > maxBytes) {
      throw new McapException(
          what + " has " + bytes + " bytes: expected at most " + maxBytes + " with this heap");
    }
  }

  private void copyChunk(RecordSearch.Found found) throws IOException {
    ChunkContent.Salvage salvage;
    try {
      RecordFields in = content(found);
      ChunkContent chunk = found.isCut() ? ChunkContent.readBrokenOff(in) : ChunkContent.read(in);
      requireHeld("the chunk at byte " + found.offset(), chunk.size());
      salvage = chunk.salvage();
    } catch (McapException e) {
      damagedChunks++;
      throw e;
    }
    boolean isDamaged = salvage.trouble() != null && !found.isCut();
    if (isDamaged) {
      damagedChunks++;
      note("the chunk at byte " + found.offset() + ": " + salvage.trouble().getMessage());
    }
    for (RecordStream.Entry entry : salvage.records()) {
      try {
        if (entry.opcode() != Opcode.MESSAGE) {
          definitions.take(
              isDamaged ? Definitions.Source.DAMAGED_CHUNK : Definitions.Source.DATA,
              entry.opcode(),
              entry.fields());
        } else if (!isDamaged) {
          copy(McapMessage.read(entry.fields()));
        }
      } catch (McapException e) {
        note(e.getMessage());
      }
    }
  }

  private void copy(McapMessage message) throws IOException {
    McapChannel channel = definitions.channel(message.channelId());
    if (channel == null) {
      note("a message belongs to the unknown channel " + message.channelId());
      return;
    }
    if (message.logTimeNanos() < 0) {
      note("a message has a log time of 2^63 ns or more: it is left out");
      return;
    }
    define(channel);
    writer.add(message);
    messages++;
  }

  private void define(McapChannel channel) throws IOException {
    if (!channels.add(channel.id())) {
      return;
    }
    McapSchema schema = definitions.schema(channel.schemaId());
    if (schema != null && schemas.add(schema.id())) {
      writer.add(schema);
    }
    writer.add(
        schema != null
            ? channel
            : new McapChannel(
                channel.id(), 0, channel.topic(), channel.messageEncoding(), channel.metadata()));
  }

  private void note(String what) {
    if (trouble == null) {
      trouble = what;
    }
  }
}
