package org.u2sa.gcs.view;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.SchemaText;
import org.u2sa.recorder.foxglove.FoxgloveMessages;
import org.u2sa.report.message.MessageJson;
import org.u2sa.report.message.ViewerJson;

/**
 * Converts messages for viewers: each message as JSON on its topic, and its views in protobuf, with
 * the same topics and schemas as a recording. Not thread-safe.
 */
public final class ViewFeed {
  private static final Set<String> LATCHED_VIEWS = Set.of("grid", "objects", "plan");

  private final ViewServer server;
  private final String systemId;
  private final FoxgloveMessages views;
  private final boolean makesViews;

  /**
   * @param makesViews false if views come from elsewhere, such as a recording that contains them
   */
  public ViewFeed(ViewServer server, String systemId, boolean makesViews) {
    this.server = server;
    this.systemId = systemId;
    this.makesViews = makesViews;
    views = new FoxgloveMessages(systemId);
  }

  /**
   * Processes a message. A message that cannot be shown, such as a position beyond every
   * projection, is only omitted.
   *
   * @param nanos time of receipt [ns]
   */
  public void take(Channel<?> channel, U2SAData message, long nanos) {
    Topic topic = Topic.of(systemId, channel, message);
    try {
      show(topic, channel, message, nanos);
    } catch (RuntimeException e) {
      server.notShown(topic.toString(), e);
    }
  }

  private void show(Topic topic, Channel<?> channel, U2SAData message, long nanos) {
    if (!server.hasRoomFor(topic.toString())) {
      return;
    }
    ViewChannel own =
        server.channel(
            topic.toString(),
            ViewChannel.JSON,
            MessageJson.typeName(message),
            () ->
                ViewerJson.schema(message.type().name(), SchemaText.of(message.type()))
                    .getBytes(StandardCharsets.UTF_8),
            channel.isRetained());
    server.publish(
        own, nanos, () -> ViewerJson.fields(message).line().getBytes(StandardCharsets.UTF_8));
    if (!makesViews) {
      return;
    }
    try {
      views.write(channel, message, nanos, view -> take(view, nanos));
    } catch (IOException e) {
      throw new UncheckedIOException("views are made in memory", e);
    }
  }

  private void take(FoxgloveMessages.View view, long nanos) {
    String name = view.topic().substring(view.topic().lastIndexOf('/') + 1);
    if (!server.hasRoomFor(view.topic())) {
      return;
    }
    ViewChannel channel =
        server.channel(
            view.topic(),
            ViewChannel.PROTOBUF,
            view.schemaName(),
            view::schemaData,
            LATCHED_VIEWS.contains(name));
    server.publish(channel, nanos, view::data);
  }
}
