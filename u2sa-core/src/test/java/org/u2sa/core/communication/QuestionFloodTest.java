package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.contract.ArmCommand;
import org.u2sa.messages.contract.ConfigurationUndo;
import org.u2sa.messages.contract.DiscoveryRequest;

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
}
