package org.u2sa.gcs.view;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.recorder.mcap.record.McapSchema;
import org.u2sa.recorder.playback.Playback;
import org.u2sa.recorder.playback.RecordedMessages;
import org.u2sa.recorder.playback.RecordedSpan;
import org.u2sa.report.message.ViewerJson;

/** Plays a recording to viewers once one is connected. */
public final class RecordedView {
  private static final double WAIT_FOR_SUBSCRIPTIONS_S = 2.0;
  private static final double LOOK_S = 0.05;

  private final RecordedMessages recording;
  private final McapReader reader;
  private final Clock clock;
  private final BooleanSupplier isOver;

  /**
   * @param clock real time
   * @param isOver polled frequently: whether to stop
   */
  public RecordedView(RecordedMessages recording, Clock clock, BooleanSupplier isOver) {
    this.recording = recording;
    reader = recording.reader();
    this.clock = clock;
    this.isOver = isOver;
  }

  private boolean hasViews() {
    return reader.channels().values().stream().anyMatch(RecordedView::isView);
  }

  private static boolean isView(McapChannel channel) {
    return channel.messageEncoding().equals(ViewChannel.PROTOBUF);
  }

  /**
   * Waits for a viewer, then plays.
   *
   * @param rate playback speed relative to the recording
   * @param span part to play
   * @param loop whether to restart at the end
   */
  public void play(ViewServer server, double rate, RecordedSpan span, boolean loop)
      throws IOException, InterruptedException {
    ViewFeed feed = new ViewFeed(server, recording.systemId().orElse("recording"), !hasViews());
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
      new Playback(reader, channel -> true, span, rate, loop, clock)
          .play(new ToViewers(server, feed), isOver);
      while (!isOver.getAsBoolean() && server.viewers() > 0) { // keep the end visible
        waiter.await(clock.micros() + Clock.micros(LOOK_S));
      }
    }
  }

  /** Announces all channels of the file, so that viewers can subscribe before it plays. */
  private void announce(ViewServer server) {
    for (McapChannel channel : reader.channels().values()) {
      McapSchema schema = reader.schemas().get(channel.schemaId());
      Optional<Topic> topic = recording.topic(channel);
      if (schema != null && (isView(channel) || topic.isPresent())) {
        boolean latched =
            topic.map(each -> Channels.namedOrNew(each.channel()).isRetained()).orElse(false);
        server.channel(
            channel.topic(),
            isView(channel) ? ViewChannel.PROTOBUF : ViewChannel.JSON,
            schema.name(),
            () -> isView(channel) ? schema.data() : forViewers(schema),
            latched);
      }
    }
  }

  private static byte[] forViewers(McapSchema schema) {
    String recorded = new String(schema.data(), StandardCharsets.UTF_8);
    return ViewerJson.schema(schema.name(), recorded).getBytes(StandardCharsets.UTF_8);
  }

  /** Passes views on unchanged, and converts messages. */
  private final class ToViewers implements Playback.Sink {
    private final ViewServer server;
    private final ViewFeed feed;

    ToViewers(ViewServer server, ViewFeed feed) {
      this.server = server;
      this.feed = feed;
    }

    @Override
    public void at(Playback.Position position) {
      server.time(position.nanos());
    }

    @Override
    public void play(McapMessage message) {
      McapChannel channel = reader.channels().get(message.channelId());
      if (isView(channel)) {
        McapSchema schema = reader.schemas().get(channel.schemaId());
        server.publish(
            server.channel(
                channel.topic(), ViewChannel.PROTOBUF, schema.name(), schema::data, false),
            message.logTimeNanos(),
            message::data);
      }
      recording
          .topic(channel)
          .ifPresent(
              topic ->
                  recording
                      .decode(topic, message)
                      .ifPresent(
                          decoded ->
                              feed.take(
                                  Channels.namedOrNew(topic.channel()),
                                  decoded,
                                  message.logTimeNanos())));
    }
  }
}
