package org.u2sa.interfaces.communication;

import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import org.u2sa.messages.MessageType;

/**
 * Where a message stands on the broker: {@code u2sa/<systemId>/<channel>/<TypeChain…>}, for example
 * {@code u2sa/cessna/actuation/ActuatorCommand/PercentageCommand}. Thesis 8.2.5: the chain lets a
 * reader take an unknown subclass for its nearest known ancestor.
 *
 * @param systemId the vehicle
 * @param channel the channel's name
 * @param typeChain the message's types, base first
 */
public record Topic(String systemId, String channel, List<String> typeChain) {
  /** In the place of a system ID in a filter: every system on the broker. */
  public static final String ANY_SYSTEM = "+";

  private static final String ROOT = "u2sa";
  private static final int FIRST_TYPE = 3;
  private static final Pattern SYSTEM_ID = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_.-]{0,63}");

  public Topic {
    checkSystemId(systemId);
    typeChain = List.copyOf(typeChain);
  }

  /** The topic of a message of the given type. */
  public static Topic of(String systemId, Channel<?> channel, MessageType<?> type) {
    return new Topic(systemId, channel.name(), type.chain());
  }

  /**
   * Reads a topic.
   *
   * @throws IllegalArgumentException if it is not of the form above
   */
  public static Topic parse(String topic) {
    String[] levels = topic.split("/", -1);
    if (levels.length <= FIRST_TYPE
        || !levels[0].equals(ROOT)
        || Arrays.asList(levels).contains("")) {
      throw new IllegalArgumentException(
          "topic \"" + topic + "\": expected u2sa/<systemId>/<channel>/<type…>");
    }
    return new Topic(
        levels[1], levels[2], Arrays.asList(levels).subList(FIRST_TYPE, levels.length));
  }

  /**
   * The filter that matches all messages of a channel, subclasses included.
   *
   * @param systemId the vehicle, or {@link #ANY_SYSTEM}
   */
  public static String filter(String systemId, Channel<?> channel) {
    String system = systemId.equals(ANY_SYSTEM) ? systemId : checkSystemId(systemId);
    List<String> chain = channel.type().chain(); // empty for a channel of any message
    String base = ROOT + "/" + system + "/" + channel.name();
    return chain.isEmpty() ? base + "/#" : base + "/" + String.join("/", chain) + "/#";
  }

  /**
   * Checks a system ID: 1…64 letters, digits, '_', '.' or '-', beginning with a letter or digit.
   *
   * @throws IllegalArgumentException if it is not one
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
    return ROOT + "/" + systemId + "/" + channel + "/" + String.join("/", typeChain);
  }
}
