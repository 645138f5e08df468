package org.u2sa.recorder.mcap;

import java.io.EOFException;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Makes a whole file of one that breaks off or is damaged. Belongs to one thread. */
public final class McapRecovery {
  private final McapWriter writer;
  private final Set<Integer> schemas = new HashSet<>();
  private final Set<Integer> channels = new HashSet<>();
  private long messages;
  private String trouble;

  /**
   * What was recovered.
   *
   * @param messages how many
   * @param trouble what was wrong with the file, first thing first; empty: nothing
   */
  public record Result(long messages, Optional<String> trouble) {}

  private McapRecovery(McapWriter writer) {
    this.writer = writer;
  }

  /**
   * Copies all that can be read.
   *
   * @param broken is not changed
   * @param whole is made anew; must not exist
   * @param library for the header of the new file
   * @throws IOException if one cannot be read or the other not written
   */
  public static Result recover(Path broken, Path whole, String library) throws IOException {
    try (FileChannel from = FileChannel.open(broken, StandardOpenOption.READ);
        FileChannel to =
            FileChannel.open(whole, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
        McapWriter writer = new McapWriter(to, McapOptions.usual(ChunkCompression.LZ4, library))) {
      McapRecovery recovery = new McapRecovery(writer);
      recovery.copy(from);
      return new Result(recovery.messages, Optional.ofNullable(recovery.trouble));
    }
  }

  private void copy(FileChannel from) throws IOException {
    try {
      RecordWalk.requireMagic(from, 0);
      copy(from, new RecordStream(from, Opcode.magic().length));
    } catch (McapException e) { // what is not MCAP has nothing to recover
      note(e);
    }
    if (trouble != null) {
      Map<String, String> facts = new LinkedHashMap<>();
      facts.put("trouble", trouble);
      facts.put("bytes", Long.toString(from.size()));
      facts.put("messages", Long.toString(messages));
      writer.add(new McapMetadata("recovery", facts));
    }
  }

  private void copy(FileChannel from, RecordStream stream) throws IOException {
    int opcode = 0;
    while (opcode != Opcode.DATA_END && opcode != Opcode.FOOTER) {
      try {
        RecordStream.Entry entry = stream.next();
        opcode = entry.opcode();
        if (opcode == Opcode.CHUNK) {
          salvage(ChunkContent.read(entry.fields()));
        } else {
          copy(entry);
        }
      } catch (EOFException e) {
        note(e);
        salvageLast(stream);
        return;
      } catch (McapException e) {
        note(e);
        if (opcode == 0 || stream.peek() == null) {
          return;
        }
        opcode = 0; // if the next one is none either, there is no way on
      }
    }
    if (opcode == Opcode.DATA_END) {
      requireEnd(from, stream);
    }
  }

  /** Data that are whole may be followed by a summary that is not. */
  private void requireEnd(FileChannel from, RecordStream stream) throws IOException {
    try {
      int opcode = 0;
      while (opcode != Opcode.FOOTER) {
        opcode = stream.next().opcode();
      }
      RecordWalk.requireMagic(from, stream.position());
    } catch (EOFException | McapException e) {
      note(e);
    }
  }

  private void salvageLast(RecordStream stream) throws IOException {
    long[] prefix = stream.peek();
    if (prefix != null && prefix[0] == Opcode.CHUNK) {
      try {
        salvage(ChunkContent.readBrokenOff(new RecordFields(stream.rest())));
      } catch (McapException e) { // not even its beginning is there
        note(e);
      }
    }
  }

  private void salvage(ChunkContent chunk) throws IOException {
    ChunkContent.Salvage salvage = chunk.salvage();
    for (RecordStream.Entry entry : salvage.records()) {
      copy(entry);
    }
    if (salvage.trouble() != null) {
      note(salvage.trouble());
    }
  }

  private void copy(RecordStream.Entry entry) throws IOException {
    RecordFields in = entry.fields();
    switch (entry.opcode()) {
      case Opcode.SCHEMA -> {
        McapSchema schema = McapSchema.read(in);
        if (schema.id() != 0 && schemas.add(schema.id())) {
          writer.add(schema);
        }
      }
      case Opcode.CHANNEL -> {
        McapChannel channel = McapChannel.read(in);
        if (channels.add(channel.id())) {
          writer.add(channel);
        }
      }
      case Opcode.MESSAGE -> copy(McapMessage.read(in));
      case Opcode.ATTACHMENT -> writer.add(McapAttachment.read(in));
      case Opcode.METADATA -> writer.add(McapMetadata.read(in));
      default -> {
        // header, indexes and summary are made anew
      }
    }
  }

  private void copy(McapMessage message) throws IOException {
    if (channels.contains(message.channelId())) {
      writer.add(message);
      messages++;
    } else {
      note(new McapException("a message is of channel " + message.channelId() + ", unknown"));
    }
  }

  private void note(IOException what) {
    if (trouble == null) {
      trouble = what.getMessage();
    }
  }
}
