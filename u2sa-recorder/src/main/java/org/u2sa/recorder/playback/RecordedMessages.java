package org.u2sa.recorder.playback;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/** Reads a recording's native messages, by topic and decoded. Not thread-safe. */
public final class RecordedMessages implements AutoCloseable {
  private static final String ENCODING = "cbor";

  private final Path file;
  private final McapReader reader;
  private final Map<Integer, Topic> topics = new TreeMap<>();
  private final MessageCodec codec = new MessageCodec(MessageTypes.discovered());
  private int foreign; // channels
  private String firstForeign = "";
  private final Map<Integer, Long> undecodable = new HashMap<>(); // most in one pass, by channel
  private String firstUndecodable = "";

  /** Receives messages in sequence. */
  @FunctionalInterface
  public interface Taker {
    /**
     * Receives a message.
     *
     * @param logNanos recording time [ns of the recording's clock]
     */
    void take(Topic topic, U2SAData message, long logNanos) throws IOException;
  }

  private RecordedMessages(Path file, McapReader reader) {
    this.file = file;
    this.reader = reader;
    for (McapChannel channel : reader.channels().values()) {
      if (channel.messageEncoding().equals(ENCODING)) {
        parse(channel);
      }
    }
  }

  /**
   * Opens a recording.
   *
   * @throws BadInputException if the file does not exist
   * @throws IOException if it cannot be read or is not a complete MCAP file
   */
  public static RecordedMessages open(Path file) throws IOException {
    RegularFile.require(file, "a recording (MCAP)");
    return new RecordedMessages(file, McapReader.open(file));
  }

  private void parse(McapChannel channel) {
    try {
      topics.put(channel.id(), Topic.parse(channel.topic()));
    } catch (IllegalArgumentException e) { // CBOR of another program
      if (foreign++ == 0) {
        firstForeign = e.getMessage();
      }
    }
  }

  /** Underlying MCAP file, for everything but U2SA messages. */
  public McapReader reader() {
    return reader;
  }

  /** Topic of a channel; empty if its messages are not native U2SA messages. */
  public Optional<Topic> topic(McapChannel channel) {
    return Optional.ofNullable(topics.get(channel.id()));
  }

  /** Recorded system; empty if the file has no native messages. */
  public Optional<String> systemId() {
    return topics.values().stream().map(Topic::systemId).findFirst();
  }

  /**
   * Rejects a recording without native messages.
   *
   * @return this
   * @throws BadInputException explaining how to record them
   */
  public RecordedMessages requireMessages() {
    if (topics.isEmpty()) {
      throw new BadInputException(
          file
              + ": holds no native messages"
              + undecodable().map(what -> " (" + what + ")").orElse("")
              + "; expected a recording made with --form u2sa or both");
    }
    return this;
  }

  /**
   * Selects channels of the file.
   *
   * @param names U2SA channel names, such as {@code state}; empty for all
   * @throws BadInputException if one was not recorded; lists those that were
   */
  public Predicate<McapChannel> channels(Collection<String> names) {
    Set<String> recorded =
        topics.values().stream().map(Topic::channel).collect(Collectors.toCollection(TreeSet::new));
    Set<String> unknown = new TreeSet<>(names);
    unknown.removeAll(recorded);
    if (!unknown.isEmpty()) {
      throw new BadInputException(
          file + ": has no channel " + unknown + "; expected some of " + recorded);
    }
    return channel -> {
      Topic topic = topics.get(channel.id());
      return topic != null && (names.isEmpty() || names.contains(topic.channel()));
    };
  }

  /**
   * Decodes a message; empty if that fails, which {@link #undecodable} reports. A single malformed
   * message, e.g. from an attacker, must not make a recording unusable.
   */
  public Optional<U2SAData> decode(Topic topic, McapMessage recorded) {
    return decode(topic, recorded, undecodable);
  }

  private Optional<U2SAData> decode(
      Topic topic, McapMessage recorded, Map<Integer, Long> failures) {
    try {
      return Optional.of(codec.decode(topic.typeChain(), recorded.data()));
    } catch (MalformedMessageException e) {
      failures.merge(recorded.channelId(), 1L, Long::sum);
      if (firstUndecodable.isEmpty()) {
        firstUndecodable = topic + ": " + e.getMessage();
      }
      return Optional.empty();
    }
  }

  /** Channels left out and decoding failures so far, in words; empty if none. */
  public Optional<String> undecodable() {
    List<String> what = new ArrayList<>();
    if (foreign > 0) {
      what.add("channels left out for their topics: " + foreign + ", the first: " + firstForeign);
    }
    if (!undecodable.isEmpty()) {
      what.add(
          "messages that cannot be decoded: "
              + undecodable.values().stream().mapToLong(Long::longValue).sum()
              + ", the first on "
              + firstUndecodable);
    }
    return what.isEmpty() ? Optional.empty() : Optional.of(String.join("; ", what));
  }

  /**
   * Passes all decodable messages of the selected channels to the receiver, in log-time order. May
   * be called several times; {@link #undecodable} counts each message once.
   *
   * @param wanted channels, see {@link #channels}
   * @param span part to read
   */
  public void forEach(Predicate<McapChannel> wanted, RecordedSpan span, Taker taker)
      throws IOException {
    Map<Integer, Long> failures = new HashMap<>();
    McapCursor cursor = reader.messages(span.fromNanos(), wanted);
    for (Optional<McapMessage> m = cursor.next();
        m.isPresent() && m.get().logTimeNanos() <= span.toNanos();
        m = cursor.next()) {
      Topic topic = topics.get(m.get().channelId());
      Optional<U2SAData> message = decode(topic, m.get(), failures);
      if (message.isPresent()) {
        taker.take(topic, message.get(), m.get().logTimeNanos());
      }
    }
    failures.forEach((channel, count) -> undecodable.merge(channel, count, Math::max));
  }

  @Override
  public void close() throws IOException {
    reader.close();
  }
}
