package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

/** Names of services and batteries that do not exist: they would disable failsafes. */
@Timeout(30)
class NamedServicesTest extends WatchedVehicle {
  @ParameterizedTest
  @CsvSource({
    "ACTUATOR SERVICES,'Motor, Nobody',actuator link: service Nobody has not reported",
    "ESTIMATOR SERVICE,Nobody,state estimator: service Nobody has not reported"
  })
  void arm_serviceThatHasNotReported_isRefusedUntilItDoes(
      String variable, String value, String reason) {
    kit.with(variable, value);
    start();
    live(0.3);
    assertThat(arm(true).reasons()).containsExactly(reason);

    kit.publish(
        Channels.HEALTH, new HealthReport().serviceName("Nobody").status(ServiceStatus.RUNNING));
    live(0.3);
    assertThat(arm(true).armed()).isTrue();
  }

  @ParameterizedTest
  @CsvSource({
    "ACTUATOR SERVICES,Motor,Nobody",
    "ESTIMATOR SERVICE,Rudder,Nobody",
    "HEALTH MONITOR SERVICE,Motor,Nobody",
    "BATTERIES,main,Nobody"
  })
  void configurationRefusal_serviceThatHasNotReported_onlyInMotion(
      String variable, String known, String unknown) {
    SafetyManager manager = start();
    live(0.3);
    assertThat(manager.setVariable(variable, unknown)).isTrue();
    assertThat(manager.setVariable(variable, known)).isTrue();
    battery(12.5, 80.0);
    live(0.3);
    assertThat(arm(true).reasons()).isEmpty();

    assertThat(manager.setVariable(variable, unknown)).isFalse();
    assertThat(manager.getVariable(variable)).isEqualTo(known);
    assertThat(kit.log("SafetyManager"))
        .anyMatch(line -> line.contains("\"Nobody\" has not reported"));
    assertThat(manager.setVariable(variable, "")).isTrue();
  }

  @Test
  void rate_thatWouldBlindIt_isRefused() {
    kit.with("RATE", 0.001);
    assertThatThrownBy(this::start).hasMessageContaining("RATE").hasMessageContaining("0.001");
  }
}
