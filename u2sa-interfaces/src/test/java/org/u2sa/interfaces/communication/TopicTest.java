package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;

class TopicTest {
  @Test
  void of_subclass_namesTheWholeChain() {
    assertThat(Topic.of("cessna", Channels.ACTUATION, PercentageCommand.TYPE))
        .hasToString("u2sa/cessna/actuation/ActuatorCommand/PercentageCommand");
  }

  @Test
  void filter_typedChannel_matchesSubclasses() {
    assertThat(Topic.filter("cessna", Channels.ACTUATION))
        .isEqualTo("u2sa/cessna/actuation/ActuatorCommand/#");
  }

  @Test
  void filter_channelOfAnyMessage_endsAfterTheChannel() {
    assertThat(Topic.filter("cessna", Channels.DISCOVERY)).isEqualTo("u2sa/cessna/discovery/#");
  }

  @Test
  void filter_anySystem_hasTheWildcardInItsPlace() {
    assertThat(Topic.filter(Topic.ANY_SYSTEM, Channels.HEALTH))
        .isEqualTo("u2sa/+/health/HealthReport/#");
  }

  @ParameterizedTest
  @ValueSource(strings = {"#", "a/b", "", "++"})
  void filter_systemIdThatIsNone_isRefused(String systemId) {
    assertThatThrownBy(() -> Topic.filter(systemId, Channels.HEALTH))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void parse_ofToString_givesTheSame() {
    Topic topic = new Topic("cessna", "state", List.of("StateInformation", "AircraftState"));

    assertThat(Topic.parse(topic.toString())).isEqualTo(topic);
  }

  @Test
  void of_retainedMessageOfOneOfSeveral_endsWithItsSource() {
    ActuatorAnnouncement flap = new ActuatorAnnouncement().actuatorName("FLAP/1 %\n");

    Topic topic = Topic.of("cessna", Channels.ACTUATORS, flap);

    assertThat(topic)
        .hasToString("u2sa/cessna/actuators/ActuatorAnnouncement/=FLAP%002F1%0020%0025%000A");
    assertThat(Topic.parse(topic.toString()).source()).isEqualTo("FLAP/1 %\n");
  }

  @ParameterizedTest
  @ValueSource(strings = {"1Tide", "-Tide", "Ti-de", "Tide+", "T#", "Ti de", "\u200bT", "T\u200b"})
  void parse_levelThatIsNoTypesName_isRefused(String type) {
    String topic = "u2sa/a/state/" + type;
    assertThatThrownBy(() -> Topic.parse(topic))
        .hasMessage("topic \"" + topic + "\": expected a channel's name and then names of types");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          ''                           | topic "": expected u2sa/<systemId>/<channel>/<type…>
          u2sa/a/state                 | expected u2sa/<systemId>/<channel>/<type…>
          u2sb/a/state/T               | expected u2sa/<systemId>/<channel>/<type…>
          u2sa//state/T                | expected u2sa/<systemId>/<channel>/<type…>
          u2sa/a/state//T              | expected u2sa/<systemId>/<channel>/<type…>
          u2sa/a/state/T/              | expected u2sa/<systemId>/<channel>/<type…>
          u2sa/a b/state/T             | system ID "a b": expected 1 to 64 letters
          u2sa/a/State/T               | expected a channel's name and then names of types
          u2sa/a/state/=GPS            | expected a type before the source "=GPS"
          u2sa/a/actuators/T/=         | expected the source's name after '='
          u2sa/a/actuators/T/=%2F      | expected four hexadecimal digits after '%'
          u2sa/a/actuators/T/=%0041    | source "%0041": expected "A"
          u2sa/a/actuators/T/=%002f    | source "%002f": expected "%002F"
          """)
  void parse_otherForm_saysWhatWasExpected(String topic, String expected) {
    assertThatThrownBy(() -> Topic.parse(topic))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining(expected);
  }

  @Test
  void parse_channelOfTenThousandWords_takesNoStackForEach() {
    String channel = "a" + "-1b".repeat(10_000);
    assertThat(Topic.parse("u2sa/ugv/" + channel + "/ObjectList").channel()).isEqualTo(channel);
    assertThatThrownBy(() -> Topic.parse("u2sa/ugv/" + channel + "-/ObjectList"))
        .isInstanceOf(IllegalArgumentException.class);
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
}
