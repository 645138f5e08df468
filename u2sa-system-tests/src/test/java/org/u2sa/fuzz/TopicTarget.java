package org.u2sa.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** Topics as a broker hands them over, and the filters of the channels that they name. */
public final class TopicTarget {
  private static final MessageTypes TYPES = StandardTypes.registry();

  private TopicTarget() {}

  /** Called by the fuzzer. */
  public static void fuzzerTestOneInput(byte[] data) {
    String text = new String(data, StandardCharsets.UTF_8);
    Topic topic;
    try {
      topic = Topic.parse(text);
    } catch (IllegalArgumentException e) {
      Agreement.require(!e.getMessage().isEmpty(), "reason", e.getMessage(), "a sentence");
      return;
    }
    boolean asBeforeFormat3 = text.substring(text.lastIndexOf('/')).matches("(?s)/=.*[ .*>].*");
    Agreement.require(topic.toString().equals(text) || asBeforeFormat3, "text", topic, text);
    Agreement.require(Topic.parse(topic.toString()).equals(topic), "read again", topic, text);
    try {
      filtered(topic, TYPES.nearest(topic.typeChain()));
    } catch (MalformedMessageException refusedChain) {
      Agreement.require(
          TYPES.all().stream().noneMatch(type -> type.chain().equals(topic.typeChain())),
          "chain",
          topic,
          "one that is too long, or not the ancestry of the type that it ends with");
    } catch (IllegalArgumentException notAChannel) {
      Agreement.require(
          !topic.channel().matches("[a-z][a-z0-9]*(-[a-z0-9]+)*"), "channel", topic, notAChannel);
    }
  }

  /** The filter of the topic's channel is nothing but levels of the topic and one wildcard. */
  private static void filtered(Topic topic, MessageType<?> type) {
    String filter = Topic.filter(topic.systemId(), Channel.every(topic.channel(), type));
    String stem = filter.substring(0, filter.length() - 1);
    Agreement.require(filter.endsWith("/#"), "filter", filter, "one that ends with /#");
    Agreement.require(
        stem.indexOf('#') < 0 && stem.indexOf('+') < 0, "filter", filter, "one wildcard");
    List<String> chain = type.chain();
    if (topic.typeChain().size() >= chain.size()
        && topic.typeChain().subList(0, chain.size()).equals(chain)) {
      Agreement.require((topic + "/").startsWith(stem), "filter", filter, topic);
    }
  }
}
