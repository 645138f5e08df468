package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.safety.ArmCommand;

/** Clients that ask or order without end. */
@Timeout(120)
class QuestionFloodTest {
  private static final int MANY = 5_000; // more than arrive in the test's time

  private final TestManager broker =
      new TestManager(Map.of("CLIENT QUESTIONS PER SECOND", 10, "CLIENT ORDERS PER SECOND", 1));
  private final RecordingReceiver inbox = new RecordingReceiver();

  @AfterEach
  void stop() {
    broker.close();
  }

  private Connection local() {
    Connection local = broker.local("Local", inbox);
    Channels.all().forEach(local::subscribe);
    return local;
  }

  @Test
  void questions_fromSeveralConnectionsOfOneUser_waitAndOthersCommandsPass() throws IOException {
    local();
    byte[] question = frozen(new DiscoveryRequest()).serialize();
    ArmCommand arm = frozen(new ArmCommand().arm(true).requestId("1").operator("pilot"));
    try (RawClient one = new RawClient(broker.port).introduced("one");
        RawClient other = new RawClient(broker.port).introduced("other");
        RawClient pilot = new RawClient(broker.port).introduced("pilot")) {
      for (int i = 0; i < MANY / 2; i++) {
        one.publish("u2sa/cessna/discovery/DiscoveryRequest", question, 0);
        other.publish("u2sa/cessna/discovery/DiscoveryRequest", question, 0);
      }
      pilot.publish("u2sa/cessna/arming/ArmCommand", arm.serialize(), 1);

      soon().until(() -> inbox.messages.contains(arm));
      assertThat(inbox.messages.stream().filter(DiscoveryRequest.class::isInstance))
          .hasSizeLessThan(MANY / 2);
    }
  }

  @Test
  void orders_moreThanOneClientMayGive_areRefusedAndTold() throws IOException {
    local();
    byte[] undo =
        frozen(new ConfigurationUndo().requestId("1").serviceName("Control").author("x"))
            .serialize();
    ArmCommand arm = frozen(new ArmCommand().arm(true).requestId("1").operator("pilot"));
    try (RawClient pilot = new RawClient(broker.port).introduced("pilot")) {
      for (int i = 0; i < 200; i++) {
        pilot.publish("u2sa/cessna/configuration/ConfigurationUndo", undo, 1);
      }
      pilot.publish("u2sa/cessna/arming/ArmCommand", arm.serialize(), 1);
      soon().until(() -> inbox.messages.contains(arm)); // behind them, and not held up
    }
    assertThat(broker.log).anyMatch(line -> line.contains("too many orders of one client"));
    assertThat(inbox.messages.stream().filter(ConfigurationUndo.class::isInstance))
        .hasSizeLessThan(200);
  }

  /** Every service reads them, so long ones would hold up what else it receives. */
  @Test
  void questionsAndChanges_longerThanAnyNeedsToBe_areRefusedAndTold() throws IOException {
    local();
    byte[] question = new byte[50_000]; // refused before anybody reads it
    byte[] change = frozen(change("x".repeat(50_000), "y".repeat(50_000))).serialize();
    ArmCommand arm = frozen(new ArmCommand().arm(true).requestId("1").operator("pilot"));
    try (RawClient pilot = new RawClient(broker.port).introduced("pilot")) {
      pilot.publish("u2sa/cessna/configuration/ConfigurationRequest", question, 1);
      pilot.publish("u2sa/cessna/configuration/ConfigurationTransaction", change, 1);
      pilot.publish("u2sa/cessna/arming/ArmCommand", arm.serialize(), 1);
      soon().until(() -> inbox.messages.contains(arm)); // behind them
    }
    assertThat(inbox.messages).containsExactly(arm);
    assertThat(broker.log)
        .anyMatch(line -> line.contains("longer than the 4096 of ConfigurationRequest"))
        .anyMatch(line -> line.contains("longer than the 65536 of ConfigurationTransaction"));
  }

  @Test
  void orders_long_countAsSeveral() throws IOException {
    broker.replace(Map.of("CLIENT ORDERS PER SECOND", 16)); // the first four at once
    local();
    byte[] change = frozen(change("x".repeat(60_000))).serialize(); // as sixteen
    ArmCommand arm = frozen(new ArmCommand().arm(true).requestId("1").operator("pilot"));
    try (RawClient pilot = new RawClient(broker.port).introduced("pilot")) {
      for (int i = 0; i < 4; i++) {
        pilot.publish("u2sa/cessna/configuration/ConfigurationTransaction", change, 1);
      }
      pilot.publish("u2sa/cessna/arming/ArmCommand", arm.serialize(), 1);
      soon().until(() -> inbox.messages.contains(arm));
    }
    assertThat(inbox.messages.stream().filter(ConfigurationTransaction.class::isInstance))
        .isNotEmpty()
        .hasSizeLessThan(4);
  }

  private static ConfigurationTransaction change(String... values) {
    return new ConfigurationTransaction()
        .requestId("1")
        .serviceName("Control")
        .author("pilot")
        .assignments(
            Arrays.stream(values)
                .map(value -> new ConfigurationAssignment().variableName("NOTE").value(value))
                .toList());
  }
}
