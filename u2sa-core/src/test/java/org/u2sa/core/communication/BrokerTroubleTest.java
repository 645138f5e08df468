package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.schema.U2SAData;

/** What the broker and its clients do when something on the way fails. */
@Timeout(90)
class BrokerTroubleTest extends TwoClients {
  @Test
  void publish_messageThatCannotBeEncoded_isCountedAndTheNextOnesGoOut() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));

    FunctionalityResponse tooLong = new FunctionalityResponse().serviceName("Local");
    tooLong.publishes(Collections.nCopies(40, "x".repeat(60_000)));
    tooLong.subscribes(List.of());
    frozen(tooLong);
    remote.subscribe(Channels.FUNCTIONALITY);
    soon()
        .until(
            () -> {
              local.publish(Channels.FUNCTIONALITY, tooLong);
              return broker.manager().dropped() > 0;
            });

    publishUntilReceived(command(2.0));
    assertThat(broker.log).first().asString().contains("functionality").contains("dropped");
  }

  @Test
  void reset_ofAClientThatIsIn_isNoFaultToTell() throws IOException {
    try (AttackedBroker other = new AttackedBroker(Map.of())) {
      other.stranger().introduced("echo").reset();
      other.stranger().introduced("echo").reset(); // the first one has left the broker by now
      other.servesOn();

      assertThat(other.log).noneMatch(line -> line.contains("connection failed"));
    }
  }

  @Test
  void receive_errorOfAReceiver_endsTheSessionNotTheLinkAndIsTold() {
    RecordingReceiver inbox = new RecordingReceiver();
    AtomicInteger received = new AtomicInteger();
    Receiver failing =
        new Receiver() {
          @Override
          public void receive(Channel<?> channel, U2SAData message) {
            if (received.incrementAndGet() == 1) {
              throw new NoClassDefFoundError("missing");
            }
            inbox.receive(channel, message);
          }

          @Override
          public void trouble(String what) {
            inbox.trouble(what);
          }
        };
    broker.remote("Failing", failing).subscribe(Channels.ACTUATION);

    BrokerTraffic.publishUntilReceived(local, inbox, command(3.0));

    inbox.awaitTrouble("lost: java.lang.NoClassDefFoundError: missing");
    inbox.awaitTrouble("restored");
  }

  @Test
  void publish_whileTheBrokerIsGone_isRefusedAndCounted() {
    broker.manager().close();
    remoteInbox.awaitTrouble("lost");

    assertThat(remote.publish(Channels.ACTUATION, command(1.0))).isFalse();

    assertThat(remote.refused()).isEqualTo(1);
  }
}
