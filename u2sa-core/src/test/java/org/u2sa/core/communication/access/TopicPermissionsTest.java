package org.u2sa.core.communication.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.AccessTable;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypes;

/** Every role on every channel with every chain of types, true ones and made-up ones. */
class TopicPermissionsTest {
  private static final String OWN = "my-own-channel";

  /** Share of the chains that no reader accepts which is judged: one in this many. */
  private static final int MADE_UP_SHARE = 13;

  private static final MessageTypes TYPES = StandardTypes.registry();
  private static final Set<AccessRole> OWN_CHANNELS =
      EnumSet.of(
          AccessRole.SERVICE,
          AccessRole.CONTROL,
          AccessRole.LAUNCHER,
          AccessRole.MONITOR,
          AccessRole.SAFETY);

  private final Map<AccessRole, User> users = new EnumMap<>(AccessRole.class);
  private final List<String> channels = new ArrayList<>(List.of(OWN, "stop-it", "EMERGENCY-STOP"));
  private int judged;

  TopicPermissionsTest() {
    PasswordHash none = new PasswordHash(1, new byte[12], new byte[64]);
    for (AccessRole role : AccessRole.values()) {
      users.put(role, new User(role.text(), EnumSet.of(role), List.of("cessna"), none));
    }
    Channels.all().forEach(channel -> channels.add(channel.name()));
  }

  private static List<List<String>> chains() {
    List<String> names = new ArrayList<>(List.of("Tide", "U2SAData", "OpaqueMessage"));
    TYPES.all().forEach(type -> names.add(type.name()));
    List<List<String>> chains = new ArrayList<>();
    for (String first : names) {
      chains.add(List.of(first));
      for (String second : names) { // duplicates and reversed ones among them
        chains.add(List.of(first, second));
      }
    }
    Random random = new Random(11);
    for (MessageType<?> type : TYPES.all()) {
      for (String tail : names) {
        List<String> longer = new ArrayList<>(type.chain());
        longer.add(tail);
        chains.add(longer);
        if (random.nextInt(8) > 0) {
          continue;
        }
        List<String> longest = new ArrayList<>(longer);
        longest.add(names.get(random.nextInt(names.size())));
        chains.add(longest);
        List<String> shuffled = new ArrayList<>(longest);
        Collections.shuffle(shuffled, random);
        chains.add(shuffled);
      }
    }
    return chains;
  }

  /** What a reader makes of the chain; null if it refuses it. */
  private static MessageType<?> readAs(List<String> chain) {
    try {
      return TYPES.nearest(chain);
    } catch (MalformedMessageException e) {
      return null;
    }
  }

  /** By the message's class alone, and by the rows as they stand in the table. */
  private static boolean expected(AccessRole role, String channel, MessageType<?> type) {
    boolean standardType = false;
    for (AccessRule rule : AccessTable.all()) {
      if (rule.type().messageClass().isAssignableFrom(type.messageClass())) {
        standardType = true;
        boolean here = rule.channel().name().equals(channel) || isOwn(channel);
        if (here && rule.roles().contains(role)) {
          return !isOwn(channel) || OWN_CHANNELS.contains(role);
        }
      }
    }
    return isOwn(channel) && !standardType && OWN_CHANNELS.contains(role);
  }

  private static boolean isOwn(String channel) {
    return channel.equals(OWN) || channel.equals("stop-it");
  }

  @Test
  void judge_everyRoleChannelAndChain_isByWhatAReaderMakesOfIt() {
    List<String> wrong = new ArrayList<>();
    Map<String, MessageType<?>> chains = new HashMap<>(); // null: no reader accepts it
    chains().forEach(chain -> chains.put(String.join("/", chain), readAs(chain)));
    int turn = 0;
    for (AccessRole role : AccessRole.values()) {
      TopicPermissions judge = new TopicPermissions(TYPES, users.get(role));
      for (String channel : channels) {
        Map<MessageType<?>, Boolean> allowed = new HashMap<>();
        for (Map.Entry<String, MessageType<?>> chain : chains.entrySet()) {
          MessageType<?> type = chain.getValue();
          if (type == null && turn++ % MADE_UP_SHARE != 0) {
            continue;
          }
          String topic = "u2sa/cessna/" + channel + "/" + chain.getKey();
          boolean letIn = judge.judge(topic).refusal() == null;
          boolean should =
              type != null
                  && !channel.equals("EMERGENCY-STOP")
                  && allowed.computeIfAbsent(type, known -> expected(role, channel, known));
          judged++;
          if (letIn != should) {
            wrong.add(role + " " + topic);
          }
        }
      }
    }
    assertThat(wrong).isEmpty();
    assertThat(judged).isGreaterThan(300_000);
  }

  @Test
  void judge_withoutUsers_typeAndChannelMustBelongTogetherAllTheSame() {
    TopicPermissions judge = new TopicPermissions(TYPES, null);
    for (Channel<?> channel : Channels.all()) {
      for (MessageType<?> type : TYPES.all()) {
        String topic = Topic.of("cessna", channel, type).toString();
        assertThat(judge.judge(topic).refusal() == null).as(topic).isEqualTo(channel.carries(type));
      }
    }
    assertThat(judge.judge("u2sa/cessna/discovery/DiscoveryRequest/StopCommand").refusal())
        .isEqualTo("its types are not a class and its ancestors");
    assertThat(judge.judge("u2sa/cessna/discovery/StopCommand").refusal())
        .isEqualTo("discovery does not carry StopCommand");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "u2sa/cessna/stop/StopCommand/",
        "u2sa/cessna//StopCommand",
        "/u2sa/cessna/stop/StopCommand",
        "U2SA/cessna/stop/StopCommand",
        "u2sa/cessna/STOP/StopCommand",
        "u2sa/cessna/stop/stopcommand#",
        "u2sa/cessna/stop/+",
        "u2sa/+/stop/StopCommand",
        "u2sa/cessna/stop/Stop%0043ommand",
        "u2sa/cessna/stop/StopCommand/=%0041",
        "u2sa/cessna/stop/StopCommand/=A",
        "u2sa/cessna/stop/=A/StopCommand",
        "u2sa/cessna/stop/StopCommand\u0000",
        "u2sa/cessna/stop/\u200bStopCommand",
        "$SYS/broker",
        "$share/group/u2sa/cessna/stop/StopCommand",
        "stop",
        ""
      })
  void judge_topicThatIsNoneOfU2sa_isRefusedToTheOperatorToo(String topic) {
    assertThat(new TopicPermissions(TYPES, users.get(AccessRole.OPERATOR)).judge(topic).refusal())
        .isNotNull();
    assertThat(new TopicPermissions(TYPES, null).judge(topic).refusal()).isNotNull();
  }
}
