package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.U2SAData;

/**
 * Broker topic of a message: {@code u2sa/<systemId>/<channel>/<TypeChain…>}, for example {@code
 * u2sa/cessna/actuation/ActuatorCommand/PercentageCommand}. The chain lets a reader treat an
 * unknown subclass as its nearest known ancestor (thesis 8.2.5).
 *
 * <p>On channels retained per source, the source follows the types, because a broker retains one
 * message per topic: {@code u2sa/cessna/actuators/ActuatorAnnouncement/=RUDDER}.
 *
 * @param typeChain base type first
 * @param source empty unless the channel is retained per source
 */
public record Topic(String systemId, String channel, List<String> typeChain, String source) {
  /** Wildcard system ID in a filter: all systems on the broker. */
  public static final String ANY_SYSTEM = "+";

  private static final String ROOT = "u2sa";
  private static final int FIRST_TYPE = 3;
  private static final String SOURCE = "="; // prefix of the source level; never starts a type name
  private static final Pattern SYSTEM_ID = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_.-]{0,63}");

  public Topic {
    checkSystemId(systemId);
    typeChain = List.copyOf(typeChain);
  }

  public Topic(String systemId, String channel, List<String> typeChain) {
    this(systemId, channel, typeChain, "");
  }

  public static Topic of(String systemId, Channel<?> channel, MessageType<?> type) {
    return new Topic(systemId, channel.name(), type.chain(), "");
  }

  public static Topic of(String systemId, Channel<?> channel, U2SAData message) {
    String source = channel.isRetained() ? channel.sourceOf(message) : "";
    return new Topic(systemId, channel.name(), message.typeChain(), source);
  }

  /**
   * @throws IllegalArgumentException if the text is not a topic
   */
  public static Topic parse(String topic) {
    String[] levels = topic.split("/", -1);
    if (levels.length <= FIRST_TYPE
        || !levels[0].equals(ROOT)
        || Arrays.asList(levels).contains("")) {
      throw new IllegalArgumentException(
          "topic \"" + topic + "\": expected u2sa/<systemId>/<channel>/<type…>");
    }
    String last = levels[levels.length - 1];
    boolean hasSource = last.startsWith(SOURCE);
    int types = hasSource ? levels.length - 1 : levels.length;
    if (types == FIRST_TYPE) {
      throw new IllegalArgumentException(
          "topic \"" + topic + "\": expected a type before the source \"" + last + "\"");
    }
    List<String> chain = Arrays.asList(levels).subList(FIRST_TYPE, types);
    if (!Channel.isName(levels[2]) || !chain.stream().allMatch(Topic::isTypeName)) {
      throw new IllegalArgumentException(
          "topic \"" + topic + "\": expected a channel's name and then names of types");
    }
    return new Topic(
        levels[1],
        levels[2],
        chain,
        hasSource ? TopicLevel.name(last.substring(SOURCE.length())) : "");
  }

  /** Whether this is a Java class name, which excludes wildcards. */
  private static boolean isTypeName(String level) {
    return Character.isJavaIdentifierStart(level.charAt(0))
        && level
            .chars()
            .allMatch(
                c -> Character.isJavaIdentifierPart(c) && !Character.isIdentifierIgnorable(c));
  }

  /**
   * Filter for all messages of a channel.
   *
   * @param systemId the vehicle, or {@link #ANY_SYSTEM}
   */
  public static String filter(String systemId, Channel<?> channel) {
    String system = systemId.equals(ANY_SYSTEM) ? systemId : checkSystemId(systemId);
    List<String> chain = channel.type().chain(); // empty for channels of any message
    String base = ROOT + "/" + system + "/" + channel.name();
    return chain.isEmpty() ? base + "/#" : base + "/" + String.join("/", chain) + "/#";
  }

  /**
   * Returns the ID: 1…64 letters, digits, '_', '.' or '-', beginning with a letter or digit.
   *
   * @throws IllegalArgumentException if it is invalid
   */
  public static String checkSystemId(String systemId) {
    if (!SYSTEM_ID.matcher(systemId).matches()) {
      throw new IllegalArgumentException(
          "system ID \"" + systemId + "\": expected 1 to 64 letters, digits, '_', '.' or '-'");
    }
    return systemId;
  }

  @Override
  public String toString() {
    String topic = ROOT + "/" + systemId + "/" + channel + "/" + String.join("/", typeChain);
    return source.isEmpty() ? topic : topic + "/" + SOURCE + TopicLevel.of(source);
  }
}
