package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.ServiceStatus;

/** A client that comes again under its ID before its old connection was found dead. */
@Timeout(180)
class TakeoverTest {
  private static final String HEALTH = "u2sa/cessna/health/HealthReport/ConnectionLost";
  private static final int ROUNDS = 40;

  private final RecordingReceiver inbox = new RecordingReceiver();
  private final TestManager broker = new TestManager();
  private Connection local;

  @BeforeEach
  void start() {
    local = broker.local("Local", inbox);
    local.subscribe(Channels.HEALTH);
  }

  @AfterEach
  void stop() {
    broker.close();
  }

  private static ConnectionLost lost(String name) {
    ConnectionLost lost = new ConnectionLost();
    lost.serviceName(name).status(ServiceStatus.FAILED).lastError("lost");
    return frozen(lost);
  }

  private boolean isSaid(String name) {
    return inbox.messages.contains(lost(name));
  }

  private RawClient client(String id, String willOf) throws IOException {
    return new RawClient(broker.port)
        .willing(HEALTH, lost(willOf).serialize(), false)
        .introduced(id);
  }

  @Test
  void takeover_olderConnection_endsWithoutItsWillAndTheNewersIsSaidWhenItBreaks()
      throws IOException {
    for (int round = 0; round < ROUNDS; round++) {
      RawClient older = client("twin", "older " + round);
      RawClient newer = client("twin", "newer " + round);
      assertThat(older.isPutOut()).isTrue();
      older.close();
      assertThat(newer.subscribe("u2sa/cessna/state/#")).isZero();
      assertThat(isSaid("newer " + round)).isFalse();

      newer.close(); // breaks off without a word

      String name = "newer " + round;
      soon().until(() -> isSaid(name));
      assertThat(isSaid("older " + round)).isFalse();
    }
  }

  @Test
  void takeover_newerConnectionThatSubscribedAtOnce_hearsOn() throws IOException {
    for (int round = 0; round < ROUNDS; round++) {
      RawClient older = client("twin", "older");
      assertThat(older.subscribe("u2sa/cessna/actuation/#", 1)).isEqualTo(1);
      try (RawClient newer = new RawClient(broker.port)) {
        assertThat(newer.introduceAndSubscribe("twin", "u2sa/cessna/actuation/#")).isZero();
        assertThat(older.isPutOut()).isTrue();
        older.close();

        PercentageCommand command = command(round);
        local.publish(Channels.ACTUATION, command);

        assertThat(newer.next() >> 4).as("a PUBLISH, in round %d", round).isEqualTo(3);
      }
    }
  }
}
