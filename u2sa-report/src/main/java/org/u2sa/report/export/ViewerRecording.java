package org.u2sa.report.export;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.mcap.ChunkCompression;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapOptions;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapWriter;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapException;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.report.ReportFile;
import org.u2sa.report.message.ViewerJson;

/**
 * Converts a recording for viewers without CBOR support, such as Foxglove and Lichtblick: same
 * topics and times, messages as JSON, views unchanged. Executions, attachments and metadata are
 * omitted.
 */
public final class ViewerRecording {
  private static final String VIEW = "protobuf";
  private static final String JSON = "json";

  private final RecordedMessages recording;
  private final McapReader reader;
  private final RecordedSpan span;
  private final Predicate<McapChannel> wanted;
  private final Spacing spacing;
  private final Set<Integer> schemas = new HashSet<>();
  private final Set<Integer> channels = new HashSet<>();

  /**
   * @param wanted filter of messages
   * @param withViews whether to include views
   * @param everyS minimum time between two messages of one source on a topic [s]
   */
  public ViewerRecording(
      RecordedMessages recording,
      RecordedSpan span,
      Predicate<McapChannel> wanted,
      boolean withViews,
      double everyS) {
    this.recording = recording;
    reader = recording.reader();
    this.span = span;
    this.wanted =
        channel -> wanted.test(channel) || withViews && channel.messageEncoding().equals(VIEW);
    spacing = new Spacing(everyS);
  }

  /**
   * Writes the file; an earlier export is replaced only when this one is complete. Returns the
   * number of messages.
   *
   * @throws BadInputException if the file is a recording
   */
  public long write(Path file, String library) throws IOException {
    ReportFile.refuse(file, ReportFile.isMcap(file) && !isExport(file));
    Path part = file.resolveSibling("." + file.getFileName() + ".part");
    try {
      long messages;
      try (FileChannel to =
              FileChannel.open(
                  part,
                  StandardOpenOption.CREATE,
                  StandardOpenOption.TRUNCATE_EXISTING,
                  StandardOpenOption.WRITE);
          McapWriter writer =
              new McapWriter(to, McapOptions.usual(ChunkCompression.LZ4, library))) {
        messages = write(writer);
      }
      Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
      return messages;
    } catch (IOException e) {
      throw ReportFile.notWritten(file, e);
    } finally {
      Files.deleteIfExists(part);
    }
  }

  /** Exports are complete, and have neither messages as they were published nor metadata. */
  private static boolean isExport(Path file) throws IOException {
    try (RecordedMessages there = RecordedMessages.open(file)) {
      return there.systemId().isEmpty() && there.reader().metadata().isEmpty();
    } catch (McapException | BadInputException e) {
      return false;
    }
  }

  private long write(McapWriter writer) throws IOException {
    McapCursor cursor = reader.messages(span.fromNanos(), wanted);
    long messages = 0;
    for (Optional<McapMessage> m = cursor.next();
        m.isPresent() && m.get().logTimeNanos() <= span.toNanos();
        m = cursor.next()) {
      McapMessage message = m.get();
      McapChannel channel = reader.channels().get(message.channelId());
      Optional<Topic> topic = recording.topic(channel);
      Optional<U2SAData> content = topic.flatMap(known -> recording.decode(known, message));
      double timeS = span.seconds(message.logTimeNanos());
      if (content.isPresent()
          ? spacing.takes(topic.get(), content.get(), timeS)
          : spacing.takes(channel.id(), timeS)) {
        announce(writer, channel);
        writer.add(topic.isPresent() ? converted(message, content) : message);
        messages++;
      }
    }
    return messages;
  }

  private void announce(McapWriter writer, McapChannel channel) throws IOException {
    if (!channels.add(channel.id())) {
      return;
    }
    McapSchema schema = reader.schemas().get(channel.schemaId());
    boolean isView = channel.messageEncoding().equals(VIEW);
    if (schema != null && schemas.add(schema.id())) {
      writer.add(isView ? schema : converted(schema));
    }
    writer.add(
        isView
            ? channel
            : new McapChannel(
                channel.id(), channel.schemaId(), channel.topic(), JSON, channel.metadata()));
  }

  private static McapSchema converted(McapSchema schema) {
    String text = new String(schema.data(), StandardCharsets.UTF_8);
    return new McapSchema(
        schema.id(),
        schema.name(),
        schema.encoding(),
        ViewerJson.schema(schema.name(), text).getBytes(StandardCharsets.UTF_8));
  }

  /** A message that cannot be decoded becomes an empty object. */
  private static McapMessage converted(McapMessage message, Optional<U2SAData> content) {
    String json = content.map(each -> ViewerJson.fields(each).line()).orElse("{}");
    return new McapMessage(
        message.channelId(),
        message.sequence(),
        message.logTimeNanos(),
        message.publishTimeNanos(),
        json.getBytes(StandardCharsets.UTF_8));
  }
}
