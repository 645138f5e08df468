package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;

/** Clients that send too much, or take too little. */
@Timeout(120)
class BrokerFloodTest {
  private static final int PATIENCE_S = 6;

  private AttackedBroker broker;

  private void start(double patienceS) throws IOException {
    broker = new AttackedBroker(Map.of("CLIENT PATIENCE", patienceS));
  }

  @AfterEach
  void stop() throws IOException {
    broker.close();
  }

  @Test
  void flood_fromOneClient_arrivesWholeAndHoldsNobodyUp() throws IOException {
    start(PATIENCE_S);
    AtomicLong arrived = new AtomicLong();
    Connection counting = broker.manager.transport().connect("Counting", new Counting(arrived));
    counting.subscribe(Channels.STATE);
    byte[] payload = frozen(new StateInformation().sensorName("flood").x(1.0)).serialize();
    RawClient flood = broker.stranger().introduced("flood");
    int messages = 20_000;
    for (int i = 0; i < messages; i++) {
      flood.publish(AttackedBroker.STATE, payload, 0);
      if (i == messages / 2) {
        broker.servesOn();
      }
    }
    AttackedBroker.soon().until(() -> arrived.get() == messages);
    assertThat(broker.manager.dropped()).isZero();
    counting.close();
  }

  @Test
  void subscriberThatNeverReads_losesItsOwnMessagesCountedAndNobodyElses() throws IOException {
    start(PATIENCE_S);
    RawClient deaf = broker.stranger().introduced("deaf");
    assertThat(deaf.subscribe("u2sa/#")).isZero();
    FunctionalityResponse large = new FunctionalityResponse().serviceName("Local");
    large.publishes(Collections.nCopies(20, "x".repeat(5_000)));
    large.subscribes(List.of());
    frozen(large);
    Channel<FunctionalityResponse> channel =
        Channel.latest("large", FunctionalityResponse.TYPE, message -> "all");
    whilePublishing(channel, large, "message to a slow client");
    assertThat(broker.manager.dropped()).isPositive();
    broker.servesOn();
    whilePublishing(channel, large, "it does not read");
    assertThat(deaf.isPutOut()).isTrue();
  }

  private void whilePublishing(Channel<?> channel, U2SAData message, String untilLogged) {
    AttackedBroker.soon()
        .until(
            () -> {
              for (int i = 0; i < 50; i++) {
                broker.bus.publish(channel, message);
              }
              return broker.hasLogged(untilLogged);
            });
  }

  @Test
  void clientWithNothingToRead_isNotTakenForASlowOne() throws IOException {
    start(PATIENCE_S);
    try (Connection idle = broker.remote(new RecordingReceiver())) {
      idle.subscribe(Channels.ACTUATION);
      RawClient mute = broker.stranger().introduced("mute");
      assertThat(mute.subscribe("u2sa/cessna/stop/#", 1)).isEqualTo(1);
      broker.bus.publish(Channels.STOP, frozen(new StopCommand()));
      AttackedBroker.soon()
          .until(
              () -> {
                broker.bus.publish(Channels.STOP, frozen(new StopCommand()));
                return broker.hasLogged("it does not acknowledge");
              });
      assertThat(broker.log)
          .noneMatch(line -> line.contains("too slow") && line.contains("cessna/Remote"));
    }
    broker.servesOn();
  }

  @Test
  void subscriberThatAcknowledgesNothing_underAFlood_isPutOutBeforeItsQueueFillsMemory()
      throws IOException {
    start(3_600.0); // its patience would last
    RawClient mute = broker.stranger().introduced("mute");
    assertThat(mute.subscribe("u2sa/cessna/#", 1)).isEqualTo(1);
    RawClient flood = broker.stranger().introduced("flood");
    Thread reading = new Thread(flood::isPutOut, "acknowledgements"); // else the flood is slow
    reading.setDaemon(true);
    reading.start();
    byte[] payload = new byte[100_000];
    AttackedBroker.soon()
        .until(
            () -> {
              for (int i = 0; i < 20; i++) {
                publish(flood, payload);
              }
              return broker.hasLogged("too many bytes are unacknowledged");
            });
    broker.servesOn();
    assertThat(mute.isPutOut()).isTrue();
  }

  private static void publish(RawClient client, byte[] payload) {
    try {
      client.publish(AttackedBroker.STATE, payload, 1);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private record Counting(AtomicLong arrived) implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      arrived.incrementAndGet();
    }

    @Override
    public void trouble(String what) {
      throw new IllegalStateException(what);
    }
  }
}
