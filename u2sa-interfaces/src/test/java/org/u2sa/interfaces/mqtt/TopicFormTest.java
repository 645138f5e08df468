package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;

/** What a topic refuses and why, and how names of systems are bounded. */
class TopicFormTest {
  @ParameterizedTest
  @ValueSource(strings = {"1Tide", "-Tide", "Ti-de", "Tide+", "T#", "Ti de", "\u200bT", "T\u200b"})
  void parse_levelThatIsNoTypesName_isRefused(String type) {
    String topic = "u2sa/a/state/" + type;
    assertThatThrownBy(() -> Topic.parse(topic))
        .hasMessage("topic \"" + topic + "\": expected a channel's name and then names of types");
  }

  @ParameterizedTest
  @CsvSource({
    "u2sa/a/state, expected u2sa/<systemId>/<channel>/<type…>",
    "u2sb/a/state/T, expected u2sa/<systemId>/<channel>/<type…>",
    "u2sa/a/state//T, expected u2sa/<systemId>/<channel>/<type…>",
    "u2sa/a/State/T, expected a channel's name and then names of types",
    "u2sa/a/state/=GPS, 'expected a type before the source \"=GPS\"'"
  })
  void parse_otherForm_saysWhatWasExpected(String topic, String expected) {
    assertThatThrownBy(() -> Topic.parse(topic))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("topic \"" + topic + "\": " + expected);
  }

  @Test
  void parse_severalTypes_areTheChainAndTheRest() {
    Topic topic = Topic.parse("u2sa/b-1/state/Ti_de/$Ebb2/=GPS");

    assertThat(topic.systemId()).isEqualTo("b-1");
    assertThat(topic.channel()).isEqualTo("state");
    assertThat(topic.typeChain()).containsExactly("Ti_de", "$Ebb2");
    assertThat(topic.source()).isEqualTo("GPS");
  }

  @Test
  void systemId_ofTheGreatestLength_isOneAndALongerOneIsNot() {
    assertThat(Topic.checkSystemId("x".repeat(64))).hasSize(64);
    assertThatThrownBy(() -> Topic.checkSystemId("x".repeat(65)))
        .hasMessage(
            "system ID \""
                + "x".repeat(65)
                + "\": expected 1 to 64 letters, digits, '_', '.' or '-'");
  }

  @Test
  void topicNames_ofEachMessage_areThoseOfTheTopic() {
    MqttConnection.TopicNames names = new MqttConnection.TopicNames("cessna");
    StateInformation state = new StateInformation();

    assertThat(names.of(Channels.STATE, state)).isEqualTo("u2sa/cessna/state/StateInformation");
    assertThat(names.of(Channels.STATE, state)).isSameAs(names.of(Channels.STATE, state));
    assertThat(names.of(Channels.GOALS, new GoalList())).isEqualTo("u2sa/cessna/goals/GoalList");
    assertThat(names.of(Channels.SENSED_STATE, state))
        .isEqualTo("u2sa/cessna/sensed-state/StateInformation");
  }
}
