package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.core.communication.access.TopicPermissions;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.AccessRule;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.messages.registry.StandardTypes;

/** What a verdict says besides yes and no, and which ones are remembered. */
class TopicPermissionsVerdictTest {
  private static final PasswordHash NONE = new PasswordHash(1, new byte[12], new byte[64]);

  private static TopicPermissions of(AccessRole... roles) {
    User user = new User("ann", EnumSet.of(roles[0], roles), List.of("cessna"), NONE);
    return new TopicPermissions(StandardTypes.registry(), user);
  }

  @ParameterizedTest
  @CsvSource({
    "u2sa/boat/stop/StopCommand, it belongs to another system",
    "u2sa/cessna/stop/StopCommand, role observer may not publish on stop (StopCommand)",
    "u2sa/cessna/tide/StateInformation, role observer may not publish on its own channels"
        + " (StateInformation)",
    "u2sa/cessna/stop/StateInformation, stop does not carry StateInformation",
    "u2sa/cessna/state/StateInformation/=GPS, its topic is not a U2SA topic",
    "u2sa/cessna/state, its topic is not a U2SA topic",
    "u2sa/cessna/discovery/DiscoveryRequest/StopCommand, its types are not a class and its ancestors"
  })
  void judge_forbidden_saysWhy(String topic, String why) {
    assertThat(of(AccessRole.OBSERVER).judge(topic).refusal()).isEqualTo(why);
  }

  @Test
  void judge_oneOfSeveralRolesMay_isAllowed() {
    TopicPermissions.Verdict verdict =
        of(AccessRole.OBSERVER, AccessRole.OPERATOR).judge("u2sa/cessna/stop/StopCommand");

    assertThat(verdict.refusal()).isNull();
    assertThat(verdict.topic()).hasToString("u2sa/cessna/stop/StopCommand");
    assertThat(verdict.is(AccessRule.Kind.URGENT)).isTrue();
    assertThat(verdict.is(AccessRule.Kind.ORDER)).isFalse();
  }

  @Test
  void judge_ownChannel_isOfNoKind() {
    TopicPermissions.Verdict verdict =
        of(AccessRole.SERVICE).judge("u2sa/cessna/tide/StateInformation");

    assertThat(verdict.refusal()).isNull();
    assertThat(verdict.topic()).hasToString("u2sa/cessna/tide/StateInformation");
    for (AccessRule.Kind kind : AccessRule.Kind.values()) {
      assertThat(verdict.is(kind)).isFalse();
    }
  }

  @Test
  void judge_sourceWhereTheBrokerKeepsOneOfEach_isAllowed() {
    assertThat(
            of(AccessRole.SERVICE)
                .judge("u2sa/cessna/actuators/ActuatorAnnouncement/=RUDDER")
                .refusal())
        .isNull();
  }

  @Test
  void judge_topicOfTheGreatestLengthAndDepth_isReadAndALongerOneIsNot() {
    TopicPermissions judge = of(AccessRole.SERVICE);
    String start = "u2sa/cessna/tide/";

    assertThat(judge.judge(start + "T".repeat(1_024 - start.length())).refusal()).isNull();
    TopicPermissions.Verdict longer = judge.judge(start + "T".repeat(1_025 - start.length()));
    assertThat(longer.refusal()).isEqualTo("its topic is too long");
    assertThat(longer.topic()).isNull();
    assertThat(judge.judge("/".repeat(31)).refusal()).isEqualTo("its topic is not a U2SA topic");
    assertThat(judge.judge("/".repeat(32)).refusal()).isEqualTo("its topic is too long");
  }

  @Test
  void judge_asManyTopicsAsAreRemembered_areJudgedOnce() {
    TopicPermissions judge = of(AccessRole.OBSERVER);
    TopicPermissions.Verdict first = judge.judge("t1");
    for (int i = 2; i < 256; i++) {
      judge.judge("t" + i);
    }
    TopicPermissions.Verdict last = judge.judge("t256");
    TopicPermissions.Verdict beyond = judge.judge("t257");

    assertThat(judge.judge("t1")).isSameAs(first);
    assertThat(judge.judge("t256")).isSameAs(last);
    assertThat(judge.judge("t257")).isEqualTo(beyond).isNotSameAs(beyond);
  }
}
