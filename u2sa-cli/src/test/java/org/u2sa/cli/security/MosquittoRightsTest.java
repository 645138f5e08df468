package org.u2sa.cli.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.AccessTable;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** What Mosquitto lets through by the rights that are written for it, as its manual reads them. */
class MosquittoRightsTest {
  private static final MessageTypes TYPES = StandardTypes.registry();

  private static final int CHANNEL = 2; // level of a topic

  /** Filters, split into levels, by channel; those of wildcards for all channels. */
  private final Map<String, List<String[]>> writable = new HashMap<>();

  private final Map<String, List<String[]>> denied = new HashMap<>();

  private void read(String rights) {
    for (String line : rights.split("\n")) {
      if (line.startsWith("topic write ")) {
        add(writable, line.substring("topic write ".length()).split("/"));
      } else if (line.startsWith("topic deny ")) {
        add(denied, line.substring("topic deny ".length()).split("/"));
      }
    }
  }

  private static void add(Map<String, List<String[]>> filters, String[] filter) {
    boolean isOfAll = filter.length <= CHANNEL || List.of("#", "+").contains(filter[CHANNEL]);
    filters.computeIfAbsent(isOfAll ? "" : filter[CHANNEL], of -> new ArrayList<>()).add(filter);
  }

  private boolean isLetThrough(String topic) {
    return isLetThrough(topic.split("/", -1));
  }

  /** "Any deny topics are handled before topics that grant access", mosquitto.conf(5). */
  private boolean isLetThrough(String[] levels) {
    return !matches(denied, levels) && matches(writable, levels);
  }

  private static boolean matches(Map<String, List<String[]>> filters, String[] levels) {
    for (String of : List.of(levels[CHANNEL], "")) {
      for (String[] filter : filters.getOrDefault(of, List.of())) {
        if (matches(filter, levels)) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean matches(String[] filter, String[] levels) {
    for (int i = 0; i < filter.length; i++) {
      if (filter[i].equals("#")) {
        return true;
      }
      if (i >= levels.length || !filter[i].equals("+") && !filter[i].equals(levels[i])) {
        return false;
      }
    }
    return levels.length == filter.length;
  }

  private static List<List<String>> chains() {
    List<String> names = new ArrayList<>(List.of("Tide"));
    TYPES.all().forEach(type -> names.add(type.name()));
    List<List<String>> chains = new ArrayList<>();
    for (String first : names) {
      chains.add(List.of(first));
      for (String second : names) {
        chains.add(List.of(first, second));
        for (MessageType<?> type : TYPES.all()) {
          if (type.chain().size() > 1 && type.chain().get(0).equals(first)) {
            List<String> longer = new ArrayList<>(type.chain());
            longer.add(second);
            chains.add(longer);
          }
        }
      }
    }
    TYPES.all().forEach(type -> chains.add(type.chain()));
    return chains;
  }

  /** Whether the chain is a known type's own, and the role may publish that type there. */
  private static boolean isAllowed(AccessRole role, Channel<?> channel, List<String> chain) {
    Optional<MessageType<?>> type = TYPES.byName(chain.get(chain.size() - 1));
    Optional<AccessRule> rule =
        type.filter(known -> known.chain().equals(chain))
            .flatMap(known -> AccessTable.rule(channel.name(), known));
    return rule.filter(row -> row.roles().contains(role)).isPresent();
  }

  @ParameterizedTest
  @EnumSource(AccessRole.class)
  void rights_everyChannelAndChain_areThoseOfTheTable(AccessRole role) {
    PasswordHash none = new PasswordHash(1, new byte[12], new byte[64]);
    User user = new User("somebody", EnumSet.of(role), List.of("cessna"), none);
    read(MosquittoFiles.rights(Collections.singleton(user), TYPES));
    List<String> wrong = new ArrayList<>();
    List<List<String>> chains = chains();
    for (Channel<?> channel : Channels.all()) {
      for (List<String> chain : chains) {
        List<String> levels = new ArrayList<>(List.of("u2sa", "cessna", channel.name()));
        levels.addAll(chain);
        boolean source = channel.isRetainedBySource() && chain.get(chain.size() - 1).equals("Tide");
        boolean isLetThrough = isLetThrough(levels.toArray(new String[0]));
        if (!source && isLetThrough != isAllowed(role, channel, chain)) {
          wrong.add(String.join("/", levels));
        }
      }
    }
    assertThat(wrong).isEmpty();
    assertThat(isLetThrough("u2sa/cessna/my-own/StopCommand")).isFalse();
    assertThat(isLetThrough("u2sa/boat/discovery/DiscoveryRequest")).isFalse();
  }

  @ParameterizedTest
  @EnumSource(AccessRole.class)
  void rights_ofASource_nameTheSourceLast(AccessRole role) {
    PasswordHash none = new PasswordHash(1, new byte[12], new byte[64]);
    User user = new User("somebody", EnumSet.of(role), List.of("cessna"), none);
    read(MosquittoFiles.rights(Collections.singleton(user), TYPES));

    assertThat(isLetThrough("u2sa/cessna/actuators/ActuatorAnnouncement/=RUDDER"))
        .isEqualTo(isAllowed(role, Channels.ACTUATORS, List.of("ActuatorAnnouncement")));
  }
}
