package org.u2sa.interfaces.communication;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.messages.schema.U2SAData;

/** The topics of what one system sends, composed once for each channel and type. */
final class TopicNames {
  private final String systemId;
  private final Map<String, Map<List<String>, String>> composed = new ConcurrentHashMap<>();

  TopicNames(String systemId) {
    this.systemId = systemId;
  }

  /** The topic of a message; those that a source of its own tells apart are not remembered. */
  String of(Channel<?> channel, U2SAData message) {
    if (channel.isRetained()) {
      return Topic.of(systemId, channel, message).toString();
    }
    return composed
        .computeIfAbsent(channel.name(), name -> new ConcurrentHashMap<>())
        .computeIfAbsent(
            message.typeChain(), chain -> Topic.of(systemId, channel, message).toString());
  }
}
