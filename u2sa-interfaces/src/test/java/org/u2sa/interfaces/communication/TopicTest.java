package org.u2sa.interfaces.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
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
  @ValueSource(
      strings = {
        "",
        "u2sa",
        "u2sa/a/state",
        "other/a/state/T",
        "u2sa//state/T",
        "u2sa/a/state/T/",
        "u2sa/a b/state/T",
        "u2sa/a/actuators/=RUDDER",
        "u2sa/a/actuators/T/=",
        "u2sa/a/actuators/T/=%2F",
        "u2sa/a/actuators/T/=%0041",
        "u2sa/a/actuators/T/=%002f"
      })
  void parse_otherForm_isRefused(String topic) {
    assertThatThrownBy(() -> Topic.parse(topic)).isInstanceOf(IllegalArgumentException.class);
  }
}
