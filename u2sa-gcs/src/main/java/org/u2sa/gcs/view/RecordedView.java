package org.u2sa.gcs.view;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MalformedMessageException;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.recorder.mcap.McapChannel;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapMessage;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.McapSchema;

/** Plays a recording to viewers, once somebody watches. */
final class RecordedView {
  private static final String CBOR = "cbor";
  private static final double WAIT_FOR_SUBSCRIPTIONS_S = 2.0;
  private static final double LOOK_S = 0.05;
  private static final long NANOS = 1_000L;
  private static final long TELL_TIME_MICROS = 50_000;

  private final Path file;
  private final McapReader reader;
  private final Clock clock;
  private final BooleanSupplier isOver;
  private final MessageCodec codec = new MessageCodec(MessageTypes.discovered());

  /**
   * @param clock real time
   * @param isOver asked often: whether to stop
   */
  RecordedView(Path file, McapReader reader, Clock clock, BooleanSupplier isOver) {
    this.file = file;
    this.reader = reader;
    this.clock = clock;
    this.isOver = isOver;
  }

  /** The system that was recorded; a file of views only has none. */
  String system() {
    return reader.channels().values().stream()
        .filter(channel -> channel.messageEncoding().equals(CBOR))
        .map(channel -> topic(channel).systemId())
        .findFirst()
        .orElse("recording");
  }

  private boolean hasViews() {
    return reader.channels().values().stream().anyMatch(RecordedView::isView);
  }

  private static boolean isView(McapChannel channel) {
    return channel.messageEncoding().equals(ViewChannel.PROTOBUF);
  }

  private Topic topic(McapChannel channel) {
    try {
      return Topic.parse(channel.topic());
    } catch (IllegalArgumentException e) {
      throw new BadInputException(file + ": " + e.getMessage(), e);
    }
  }

  /**
   * Waits for a viewer, and plays.
   *
   * @param rate how many times as fast as recorded
   * @param startS begin so long after the first message [s]
   * @param loop whether to begin anew at the end
   */
  void play(ViewServer server, double rate, double startS, boolean loop)
      throws IOException, InterruptedException {
    ViewFeed feed = new ViewFeed(server, system(), !hasViews());
    announce(server);
    try (Clock.Waiter waiter = clock.newWaiter("view")) {
      long came = Long.MAX_VALUE;
      while (!isOver.getAsBoolean()
          && !server.isWatched()
          && (came == Long.MAX_VALUE
              || clock.micros() - came < Clock.micros(WAIT_FOR_SUBSCRIPTIONS_S))) {
        came = server.viewers() == 0 ? Long.MAX_VALUE : Math.min(came, clock.micros());
        waiter.await(clock.micros() + Clock.micros(LOOK_S));
      }
      do {
        once(server, feed, rate, startS, waiter);
      } while (loop && !isOver.getAsBoolean());
      while (!isOver.getAsBoolean() && server.viewers() > 0) { // they may look at the end
        waiter.await(clock.micros() + Clock.micros(LOOK_S));
      }
    }
  }

  /** All channels of the file, so that viewers can choose before it plays. */
  private void announce(ViewServer server) {
    for (McapChannel channel : reader.channels().values()) {
      McapSchema schema = reader.schemas().get(channel.schemaId());
      if (schema != null && (isView(channel) || channel.messageEncoding().equals(CBOR))) {
        boolean latched =
            !isView(channel) && Channels.namedOrNew(topic(channel).channel()).isRetained();
        server.channel(
            channel.topic(),
            isView(channel) ? ViewChannel.PROTOBUF : ViewChannel.JSON,
            schema.name(),
            schema::data,
            latched);
      }
    }
  }

  private void once(
      ViewServer server, ViewFeed feed, double rate, double startS, Clock.Waiter waiter)
      throws IOException, InterruptedException {
    long fromNanos = reader.statistics().startNanos() + Math.round(startS * 1e9);
    McapCursor cursor = reader.messages(fromNanos, channel -> true);
    long beganMicros = clock.micros();
    long toldMicros = Long.MIN_VALUE;
    for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
      long nanos = m.get().logTimeNanos();
      long due = beganMicros + Math.round((nanos - fromNanos) / rate / NANOS);
      while (clock.micros() < due && !isOver.getAsBoolean()) {
        waiter.await(Math.min(due, clock.micros() + Clock.micros(LOOK_S)));
      }
      if (isOver.getAsBoolean()) {
        return;
      }
      if (toldMicros == Long.MIN_VALUE || due - toldMicros >= TELL_TIME_MICROS) {
        toldMicros = due;
        server.time(nanos);
      }
      play(server, feed, reader.channels().get(m.get().channelId()), m.get());
    }
  }

  private void play(ViewServer server, ViewFeed feed, McapChannel channel, McapMessage message) {
    if (isView(channel)) {
      McapSchema schema = reader.schemas().get(channel.schemaId());
      server.publish(
          server.channel(channel.topic(), ViewChannel.PROTOBUF, schema.name(), schema::data, false),
          message.logTimeNanos(),
          message::data);
    } else if (channel.messageEncoding().equals(CBOR)) {
      Topic topic = topic(channel);
      try {
        feed.take(
            Channels.namedOrNew(topic.channel()),
            codec.decode(topic.typeChain(), message.data()),
            message.logTimeNanos());
      } catch (MalformedMessageException e) {
        throw new BadInputException(file + ": a message on " + channel.topic() + ": " + e, e);
      }
    }
  }
}
