package org.u2sa.recorder.execution;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;

/**
 * Reads one execution, entry by entry with its messages, from a recording of one or several
 * consecutive files. Buffers about ten thousand messages, limited to a quarter of the heap. Not
 * thread-safe.
 */
final class ExecutionReader implements AutoCloseable {
  /** Read-ahead, because with concurrent threads a part may precede messages it refers to. */
  private static final int AHEAD = 2048;

  private final Deque<Path> files; // after the current one
  private final Map<Integer, McapChannel> channels = new HashMap<>(); // the same in all files
  private final Map<Integer, RecordedMessage.Track> tracks = new HashMap<>();
  private final MessageCodec codec;
  private final String topic;
  private McapReader reader; // of the current file
  private McapCursor cursor;
  private final RecentlyRead near =
      new RecentlyRead(ExecutionPart.REACH + 2 * AHEAD, Runtime.getRuntime().maxMemory() / 4);
  private final Deque<McapMessage> parts = new ArrayDeque<>();
  private PackedReader entries = new PackedReader(new byte[0]);
  private PackedReader places = new PackedReader(new byte[0]);
  private long lastMicros;
  private long nextPart;
  private Next next; // read ahead; null if not read yet

  /** An entry with its message, or null. */
  record Next(ExecutionEntry entry, RecordedMessage message) {}

  /** Reads the files of a recording, oldest first. */
  ExecutionReader(List<Path> files, MessageCodec codec, String execution) throws IOException {
    this.files = new ArrayDeque<>(files);
    this.codec = codec;
    topic = ExecutionPart.TOPIC + execution;
    open();
  }

  private void open() throws IOException {
    reader = McapReader.open(files.remove());
    channels.putAll(reader.channels());
    cursor = reader.messages(Long.MIN_VALUE, this::isWanted);
  }

  /** Log time of the recording's first message [ns]; valid while the first file is read. */
  long startNanos() {
    return reader.statistics().startNanos();
  }

  private boolean isWanted(McapChannel channel) {
    return channel.topic().equals(topic) || channel.messageEncoding().equals("cbor");
  }

  /**
   * Next entry without consuming it; empty after the last.
   *
   * @throws McapException if a part, or a message it refers to, is missing or damaged
   */
  Optional<Next> peek() throws IOException {
    if (next == null && (entries.hasMore() || beginPart())) {
      ExecutionEntry entry = ExecutionEntry.read(entries, lastMicros);
      if (entry.kind() == ExecutionEntry.Kind.READING) {
        lastMicros = entry.micros();
      }
      next = entry.kind().isOfMessage() ? withMessage(entry) : new Next(entry, null);
    }
    return Optional.ofNullable(next);
  }

  void skip() {
    next = null;
  }

  private boolean beginPart() throws IOException {
    while (parts.isEmpty()) {
      if (!readOne()) {
        return false;
      }
    }
    PackedReader part = new PackedReader(parts.remove().data());
    long number = part.number();
    if (number != nextPart) {
      throw new McapException(
          nextPart == 0
              ? "the recording begins in the middle of the execution; expected its first file"
              : "part "
                  + nextPart
                  + " of the execution is missing: messages came faster than they were recorded");
    }
    nextPart++;
    lastMicros = 0;
    entries = new PackedReader(part.bytes());
    places = part;
    return entries.hasMore() || beginPart();
  }

  private boolean readOne() throws IOException {
    Optional<McapMessage> read = cursor.next();
    while (read.isEmpty()) {
      if (files.isEmpty()) {
        return false;
      }
      reader.close();
      open();
      read = cursor.next();
    }
    McapMessage message = read.get();
    if (channel(message.channelId()).topic().equals(topic)) {
      parts.add(message);
    } else {
      near.add(message);
    }
    return true;
  }

  private McapChannel channel(int id) {
    return channels.get(id);
  }

  private Next withMessage(ExecutionEntry entry) throws IOException {
    long channelId = places.number();
    if (channelId == ExecutionPart.HERE) {
      return new Next(entry, new RecordedMessage(codec, track(places.text()), places.bytes()));
    }
    long sequence = places.number();
    McapMessage found = near.message(channelId, sequence);
    for (int i = 0; found == null && i < AHEAD && readOne(); i++) {
      found = near.message(channelId, sequence);
    }
    if (found == null) {
      throw new McapException(
          "message " + sequence + " of channel " + channelId + " is missing in the recording");
    }
    RecordedMessage.Track track = tracks.get((int) channelId);
    if (track == null) {
      track = track(channel((int) channelId).topic());
      tracks.put((int) channelId, track);
    }
    return new Next(entry, new RecordedMessage(codec, track, found.data()));
  }

  private static RecordedMessage.Track track(String messageTopic) throws McapException {
    try {
      Topic parsed = Topic.parse(messageTopic);
      return new RecordedMessage.Track(parsed, Channels.namedOrNew(parsed.channel()));
    } catch (IllegalArgumentException e) {
      throw new McapException("a message on " + messageTopic + ": " + e.getMessage(), e);
    }
  }

  @Override
  public void close() throws IOException {
    reader.close();
  }
}
