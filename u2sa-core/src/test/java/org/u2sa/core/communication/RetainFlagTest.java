package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.util.Map;
import java.util.function.Supplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/** What is retained comes with the flag to who asks later, and without it to who was there. */
@Timeout(60)
class RetainFlagTest {
  private static final String GOALS = "u2sa/cessna/goals/#";
  private static final String ANNOUNCED = "u2sa/cessna/actuators/#";
  private static final int LIVE = 0x32; // PUBLISH, QoS 1
  private static final int RETAINED = 0x33;

  private int port;
  private CommunicationManager manager;
  private Connection service;

  @BeforeEach
  void start() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = probe.getLocalPort();
    }
    manager =
        CommunicationManager.start(
            "cessna",
            XmlConfiguration.inMemory("test", Map.of("COMMUNICATION MANAGER PORT", port)),
            MessageTypes.standard(),
            line -> {});
    service = manager.transport().connect("Service", new RecordingReceiver());
  }

  @AfterEach
  void stop() {
    service.close();
    manager.close();
  }

  @Test
  void subscription_toWhatIsRetained_bringsItWithTheFlagAndNewOnesWithout() throws IOException {
    retain(GOALS, Channels.GOALS, GoalList::new);
    retain(ANNOUNCED, Channels.ACTUATORS, () -> announced("RUDDER"));
    try (RawClient late = new RawClient(port).introduced("late")) {
      assertThat(late.subscribe(GOALS, 1)).isEqualTo(1);
      assertThat(late.next()).isEqualTo(RETAINED);

      publish(Channels.GOALS, new GoalList());
      assertThat(late.next()).isEqualTo(LIVE);

      late.subscribe(GOALS, 1); // once more: brings it again
      assertThat(late.next()).isEqualTo(RETAINED);
      publish(Channels.GOALS, new GoalList());
      assertThat(late.next()).isEqualTo(LIVE);

      late.subscribe(ANNOUNCED, 1);
      assertThat(late.next()).isEqualTo(RETAINED);
    }
  }

  @Test
  void subscription_toWhatAnotherClientRetained_bringsItWithTheFlag() throws IOException {
    try (RawClient elsewhere = new RawClient(port).introduced("elsewhere");
        RawClient early = new RawClient(port).introduced("early");
        RawClient late = new RawClient(port).introduced("late")) {
      early.subscribe(GOALS, 1);
      elsewhere.publishRetained("u2sa/cessna/goals/GoalList", new GoalList().serialize());
      elsewhere.publishRetained("u2sa/cessna/goals/GoalList", new GoalList().serialize());
      assertThat(early.next()).isEqualTo(LIVE);
      assertThat(early.next()).isEqualTo(LIVE);

      late.subscribe(GOALS, 1);

      assertThat(late.next()).isEqualTo(RETAINED);
    }
  }

  /** Publishes twice: when somebody got the second one, the broker holds the first. */
  private void retain(String filter, Channel<?> channel, Supplier<U2SAData> message)
      throws IOException {
    try (RawClient witness = new RawClient(port).introduced("witness")) {
      witness.subscribe(filter, 1);
      for (int i = 0; i < 2; i++) {
        publish(channel, message.get());
        assertThat(witness.next()).isEqualTo(LIVE);
      }
    }
  }

  private void publish(Channel<?> channel, U2SAData message) {
    message.systemId("cessna");
    message.freeze();
    assertThat(service.publish(channel, message)).isTrue();
  }

  private static ActuatorAnnouncement announced(String name) {
    return new ActuatorAnnouncement().actuatorName(name).minimum(-100.0).maximum(100.0);
  }
}
