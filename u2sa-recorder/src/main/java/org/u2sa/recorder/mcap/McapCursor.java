package org.u2sa.recorder.mcap;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;

/** Messages of a file, one after the other, in the order of their log times. */
public final class McapCursor {
  /** Reads a chunk's records. */
  @FunctionalInterface
  interface Loader {
    List<RecordStream.Entry> load(ChunkIndex chunk) throws IOException;
  }

  /** A message and where it is: the chunk's offset, and its own in the chunk. */
  private record Located(McapMessage message, long chunk, long offset) {}

  private final Deque<ChunkIndex> chunks;
  private final PriorityQueue<Located> loaded =
      new PriorityQueue<>(
          Comparator.comparingLong((Located located) -> located.message.logTimeNanos())
              .thenComparingLong(Located::chunk)
              .thenComparingLong(Located::offset));
  private final long fromNanos;
  private final IntPredicate wanted;
  private final Loader loader;

  McapCursor(List<ChunkIndex> all, long fromNanos, IntPredicate wanted, Loader loader) {
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
  }

  private static boolean mayHold(ChunkIndex chunk, IntPredicate wanted) {
    Map<Integer, Long> indexes = chunk.messageIndexes();
    return indexes.isEmpty() || indexes.keySet().stream().anyMatch(wanted::test);
  }

  /**
   * The next message; empty after the last.
   *
   * @throws McapException if the chunk that holds it is damaged
   */
  public Optional<McapMessage> next() throws IOException {
    while (!chunks.isEmpty()
        && (loaded.isEmpty()
            || chunks.peek().startNanos() <= loaded.peek().message.logTimeNanos())) {
      load(chunks.poll());
    }
    return Optional.ofNullable(loaded.poll()).map(Located::message);
  }

  private void load(ChunkIndex chunk) throws IOException {
    for (RecordStream.Entry entry : loader.load(chunk)) {
      if (entry.opcode() == Opcode.MESSAGE && wanted.test(entry.fields().uint16())) {
        McapMessage message = McapMessage.read(entry.fields());
        if (message.logTimeNanos() >= fromNanos) {
          loaded.add(new Located(message, chunk.offset(), entry.offset()));
        }
      }
    }
  }
}
