package org.u2sa.core.security;

import java.util.Collections;
import java.util.List;

/**
 * Messages that a role may publish.
 *
 * @param channel the channel's name, as in the topic
 * @param types first level of the type chain that is allowed; empty: every type
 */
public record Permission(String channel, List<String> types) {
  public Permission {
    types = List.copyOf(types);
  }

  static Permission all(String channel) {
    return new Permission(channel, Collections.emptyList());
  }

  static Permission of(String channel, String... types) {
    return new Permission(channel, List.of(types));
  }

  boolean covers(String otherChannel, String firstType) {
    return channel.equals(otherChannel) && (types.isEmpty() || types.contains(firstType));
  }
}
