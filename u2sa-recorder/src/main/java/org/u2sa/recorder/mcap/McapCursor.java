package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.stream.Collectors;
import org.u2sa.recorder.mcap.record.ChunkIndex;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.Opcode;
import org.u2sa.recorder.mcap.record.RecordFields;

/** Iterates over the messages of a file in log-time order. */
public final class McapCursor {
  /** Reads a chunk's decompressed records. */
  @FunctionalInterface
  interface Loader {
    byte[] load(ChunkIndex chunk) throws IOException;
  }

  private final String file;
  private final Deque<ChunkIndex> chunks;
  private final PriorityQueue<Run> loaded =
      new PriorityQueue<>(Comparator.comparingLong(Run::nanos).thenComparingLong(run -> run.chunk));
  private final long fromNanos;
  private final BitSet wanted;
  private final Loader loader;
  private final long maxHeldBytes;
  private long heldBytes; // of loaded chunks, decompressed

  /** Remaining messages of one chunk, by log time; equal times in file order. */
  private static final class Run {
    private final long chunk;
    private final long bytes;
    private final List<McapMessage> messages;
    private int next;

    Run(ChunkIndex chunk, List<McapMessage> messages) {
      this.chunk = chunk.offset();
      bytes = chunk.size();
      this.messages = messages;
    }

    long nanos() {
      return messages.get(next).logTimeNanos();
    }
  }

  /** Limits the bytes of chunks that are held at once because their times overlap. */
  McapCursor(
      String file,
      List<ChunkIndex> all,
      long fromNanos,
      BitSet wanted,
      Loader loader,
      long maxHeldBytes) {
    this.file = file;
    chunks =
        all.stream()
            .filter(chunk -> chunk.endNanos() >= fromNanos && mayHold(chunk, wanted))
            .sorted(
                Comparator.comparingLong(ChunkIndex::startNanos)
                    .thenComparingLong(ChunkIndex::offset))
            .collect(Collectors.toCollection(ArrayDeque::new));
    this.fromNanos = fromNanos;
    this.wanted = wanted;
    this.loader = loader;
    this.maxHeldBytes = maxHeldBytes;
  }

  private static boolean mayHold(ChunkIndex chunk, BitSet wanted) {
    return chunk.messageIndexes().isEmpty()
        || chunk.messageIndexes().keySet().stream().anyMatch(wanted::get);
  }

  /**
   * Next message; empty after the last.
   *
   * @throws McapException if its chunk is damaged, or more chunks overlap in time than fit into
   *     memory
   */
  public Optional<McapMessage> next() throws IOException {
    while (!chunks.isEmpty()
        && (loaded.isEmpty() || chunks.peek().startNanos() <= loaded.peek().nanos())) {
      load(chunks.poll());
    }
    Run run = loaded.poll();
    if (run == null) {
      return Optional.empty();
    }
    McapMessage message = run.messages.get(run.next);
    run.next++;
    if (run.next < run.messages.size()) {
      loaded.add(run);
    } else {
      heldBytes -= run.bytes;
    }
    return Optional.of(message);
  }

  private void load(ChunkIndex chunk) throws IOException {
    if (chunk.size() < 0 || chunk.size() > maxHeldBytes - heldBytes) {
      throw new McapException(
          String.format(
              "%s: a chunk of %d bytes, and chunks of %d bytes at the same time: expected at most %d bytes to be held at a time; a larger heap (-Xmx) holds more",
              file, chunk.size(), heldBytes, maxHeldBytes));
    }
    List<McapMessage> messages;
    try {
      messages = messages(new RecordFields(loader.load(chunk)));
    } catch (UnsupportedCompressionException e) {
      throw new McapException(file + ": " + e.getMessage(), e);
    } catch (McapException e) {
      throw new McapException(
          String.format(
              "%s: the chunk at byte %d is damaged: %s; recover the file first",
              file, chunk.offset(), e.getMessage()),
          e);
    }
    for (int i = 1; i < messages.size(); i++) {
      if (messages.get(i).logTimeNanos() < messages.get(i - 1).logTimeNanos()) {
        messages.sort(Comparator.comparingLong(McapMessage::logTimeNanos)); // stable sort
        break;
      }
    }
    if (!messages.isEmpty()) {
      loaded.add(new Run(chunk, messages));
      heldBytes += chunk.size();
    }
  }

  private List<McapMessage> messages(RecordFields in) throws McapException {
    List<McapMessage> messages = new ArrayList<>();
    while (in.remaining() > 0) {
      int opcode = in.uint8();
      long length = in.uint64();
      if (opcode != Opcode.MESSAGE) {
        in.skip(length);
        continue;
      }
      int channel = in.uint16();
      if (!wanted.get(channel)) {
        in.skip(length - Short.BYTES);
        continue;
      }
      McapMessage message =
          new McapMessage(
              channel, in.uint32(), in.uint64(), in.uint64(), in.bytes(length - McapMessage.FIXED));
      if (message.logTimeNanos() >= fromNanos) {
        messages.add(message);
      }
    }
    return messages;
  }
}
