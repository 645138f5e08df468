package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.safety.ArmingState;

/** A client that speaks in the name of a service of the vehicle. */
@Timeout(120)
class ForgedNamesTest {
  private static final String HEALTH = "u2sa/cessna/health/HealthReport";
  private static final String LOST = HEALTH + "/ConnectionLost";
  private static final String ARMING_STATE = "u2sa/cessna/arming-state/ArmingState";

  private final TestManager broker = new TestManager();
  private final RecordingReceiver inbox = new RecordingReceiver();
  private final Connection monitor = broker.local("Monitor", inbox);
  private final Connection planner = broker.local("PathPlanner", new RecordingReceiver());

  ForgedNamesTest() {
    monitor.subscribe(Channels.HEALTH);
    monitor.subscribe(Channels.ARMING_STATE);
    planner.publish(Channels.HEALTH, report("PathPlanner", ServiceStatus.RUNNING));
  }

  @AfterEach
  void close() {
    broker.close();
  }

  private static HealthReport report(String name, ServiceStatus status) {
    return frozen(new HealthReport().serviceName(name).status(status).instance("forged"));
  }

  private static ConnectionLost lost(String name) {
    ConnectionLost lost = new ConnectionLost();
    lost.serviceName(name).status(ServiceStatus.FAILED).instance("forged").threadAlive(false);
    return frozen(lost);
  }

  private void awaitLog(String part) {
    BrokerTraffic.soon().until(() -> broker.log.stream().anyMatch(line -> line.contains(part)));
  }

  @Test
  void publish_healthUnderTheNameOfTheVehiclesService_reachesNobodyAndIsTold() throws IOException {
    HealthReport own = report("Attacker", ServiceStatus.RUNNING);
    try (RawClient attacker = new RawClient(broker.port).introduced("attacker")) {
      attacker.publish(HEALTH, report("PathPlanner", ServiceStatus.FAILED).serialize(), 1);
      attacker.publish(LOST, lost("PathPlanner").serialize(), 1);
      attacker.publish(HEALTH, own.serialize(), 1);
      inbox.awaitMessage(own);
    }

    assertThat(inbox.messages)
        .containsExactly(report("PathPlanner", ServiceStatus.RUNNING), own)
        .allMatch(message -> !((HealthReport) message).status().equals(ServiceStatus.FAILED));
    awaitLog(
        "its source name belongs to another connection: user \"anonymous\", client "
            + "\"attacker\"");
    awaitLog("name \"PathPlanner\"");
  }

  @Test
  void connectionBreaks_willInTheNameOfTheVehiclesService_isNotPublished() throws IOException {
    HealthReport after = report("Attacker", ServiceStatus.RUNNING);
    new RawClient(broker.port)
        .willing(LOST, lost("PathPlanner").serialize(), false)
        .introduced("attacker")
        .reset();
    awaitLog("will refused, its source name belongs to another connection");
    planner.publish(Channels.HEALTH, after);

    assertThat(inbox.messages).noneMatch(ConnectionLost.class::isInstance).contains(after);
  }

  @Test
  void publishRetained_armedBesideTheVehiclesSafetyManager_isNeitherHeardNorKept()
      throws IOException {
    ArmingState disarmed = frozen(new ArmingState().armed(false));
    broker.local("SafetyManager", new RecordingReceiver()).publish(Channels.ARMING_STATE, disarmed);
    try (RawClient attacker = new RawClient(broker.port).introduced("attacker")) {
      attacker.publishRetained(ARMING_STATE, frozen(new ArmingState().armed(true)).serialize());
      awaitLog("topic \"" + ARMING_STATE + "\", name \"\"");
    }
    RecordingReceiver later = new RecordingReceiver();
    broker.local("Actuator", later).subscribe(Channels.ARMING_STATE);

    assertThat(later.messages).containsExactly(disarmed);
    assertThat(inbox.messages).doesNotContain(frozen(new ArmingState().armed(true)));
  }
}
