package org.u2sa.core.security;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Topic;

class AccessRoleTest {
  private static Set<AccessRole> whoMayPublish(String topic) {
    Set<AccessRole> roles = EnumSet.noneOf(AccessRole.class);
    for (AccessRole role : AccessRole.values()) {
      if (role.mayPublish(Topic.parse("u2sa/cessna/" + topic))) {
        roles.add(role);
      }
    }
    return roles;
  }

  @ParameterizedTest
  @CsvSource({
    "actuation/ActuatorCommand/PercentageCommand, control",
    "stop/StopCommand, operator",
    "configuration/ConfigurationChange, operator",
    "configuration/ConfigurationTransaction, operator",
    "configuration/ConfigurationUndo, operator",
    "service-orders/ServiceOrder, 'monitor,operator'",
    "service-orders/ServiceOrderResult, launcher",
    "emergency-stop/EmergencyStop, 'safety,operator'",
    "arming/ArmCommand, operator",
    "arming-state/ArmingState, safety",
    "failsafe/FailsafeState, safety",
    "conditions/ServiceCondition, monitor",
    "operator/OperatorHeartbeat, operator",
    "goal-commands/GoalCommand, operator",
    "state/StateInformation, 'service,control,launcher,monitor,safety'",
    "my-own-channel/MyMessage, 'service,control,launcher,monitor,safety'",
    "health/HealthReport, 'service,control,launcher,monitor,safety,operator'",
    "discovery/DiscoveryRequest, 'service,control,launcher,monitor,safety,operator,observer'"
  })
  void mayPublish_topic_isAllowedToTheseRolesOnly(String topic, String roles) {
    assertThat(whoMayPublish(topic)).isEqualTo(User.rolesOf(roles));
  }

  @Test
  void permissions_standardChannels_areEachSomebodys() {
    List<String> nobodys = new ArrayList<>();
    for (Channel<?> channel : Channels.all()) {
      boolean covered =
          EnumSet.allOf(AccessRole.class).stream()
              .flatMap(role -> role.permissions().stream())
              .anyMatch(permission -> permission.channel().equals(channel.name()));
      if (!covered) {
        nobodys.add(channel.name());
      }
    }
    assertThat(nobodys).as("channels on which no role may publish").isEmpty();
  }

  @Test
  void permissions_channels_areStandardOnes() {
    for (AccessRole role : AccessRole.values()) {
      for (Permission permission : role.permissions()) {
        assertThat(Channels.named(permission.channel())).as(permission.channel()).isPresent();
      }
    }
  }
}
