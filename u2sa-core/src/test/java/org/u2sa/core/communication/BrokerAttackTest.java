package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.command.PercentageCommand;

/** Packets and connections that no honest client makes, and those who use the broker well. */
@Timeout(120)
class BrokerAttackTest {
  private static final String ACTUATION = "u2sa/cessna/actuation/ActuatorCommand/PercentageCommand";
  private static final byte[] COMMAND = BrokerTraffic.command(3.0).serialize();
  private static final int REFUSED = 0x80;
  private static final int COME_AGAIN = 3;

  private AttackedBroker broker;

  @BeforeEach
  void start() throws IOException {
    broker = new AttackedBroker(Map.of("MAX CLIENTS", 64));
  }

  @AfterEach
  void stop() throws IOException {
    broker.close();
  }

  @Test
  void randomBytes_fromManyConnections_areRefusedAndTheBrokerServesOn() throws IOException {
    Random random = new Random(7);
    for (int i = 0; i < 200; i++) {
      byte[] bytes = new byte[1 + random.nextInt(2_000)];
      random.nextBytes(bytes);
      try (RawClient client = new RawClient(broker.port)) {
        client.send(bytes);
      } catch (IOException e) {
        continue; // put out while it still spoke
      }
    }
    broker.servesOn();
    broker.awaitLog("malformed packet");
  }

  @Test
  void brokenPackets_afterAGoodIntroduction_putTheClientOut() throws IOException {
    Random random = new Random(8);
    for (int i = 0; i < 100; i++) {
      try (RawClient client = new RawClient(broker.port).introduced("fuzz-" + i)) {
        byte[] bytes = new byte[200];
        random.nextBytes(bytes);
        bytes[0] = (byte) (random.nextInt(16) << 4);
        bytes[1] = (byte) random.nextInt(128);
        client.send(bytes);
      }
    }
    broker.servesOn();
    broker.awaitLog("malformed packet");
  }

  @Test
  void randomPayloads_onEveryChannel_areCountedAndReachNobody() throws IOException {
    RecordingReceiver local = new RecordingReceiver();
    Connection sink = broker.manager.transport().connect("Sink", local);
    Channels.all().forEach(sink::subscribe);
    RawClient client = broker.stranger().introduced("garbage");
    Random random = new Random(9);
    for (Channel<?> channel : Channels.all()) {
      for (int i = 0; i < 20; i++) {
        byte[] payload = new byte[random.nextInt(300)];
        random.nextBytes(payload);
        client.publish(
            "u2sa/cessna/" + channel.name() + "/" + channel.type().name(), payload, i % 2);
      }
    }
    broker.servesOn();
    broker.awaitLog("cannot be read");
    assertThat(local.messages).allMatch(PercentageCommand.class::isInstance); // servesOn's
    sink.close();
  }

  @Test
  void payloadLongerThanACodecTakes_isRefusedAndItsClientGoesOn() throws IOException {
    RawClient client = broker.stranger().introduced("long");
    client.publish(AttackedBroker.STATE, new byte[BrokerLimits.LONGEST_PAYLOAD + 1], 0);
    broker.awaitLog("message refused, its payload is too long");
    assertThat(client.subscribe("u2sa/cessna/state/#")).isZero();
    broker.servesOn();
  }

  @Test
  void acknowledgementAfterGoodbye_harmsNobody() throws IOException {
    for (int i = 0; i < 8; i++) { // the broker has several threads, chosen by the client's ID
      RawClient client = broker.stranger().introduced("hasty-" + i);
      client.subscribe("u2sa/cessna/actuation/#", 1);
      broker.stranger().introduced("sender-" + i).publish(ACTUATION, COMMAND, 1);
      client.acknowledgeAfterGoodbye(client.nextMessage());
      assertThat(client.isPutOut()).isTrue();
    }
    broker.servesOn();
  }

  @Test
  void packetLongerThanAnyMayBe_putsTheClientOut() throws IOException {
    RawClient huge = broker.stranger().introduced("huge");
    huge.send(new byte[] {0x30, (byte) 0xff, (byte) 0xff, (byte) 0xff, 0x7f, 0, 1, 'x'});
    assertThat(huge.isPutOut()).isTrue();
    broker.awaitLog("malformed packet");
    broker.servesOn();
  }

  @Test
  void firstPacketThatDoesNotEnd_isCutOffBeforeItFillsMemory() throws IOException {
    RawClient stranger = broker.stranger();
    stranger.send(new byte[] {0x30, (byte) 0xc0, (byte) 0x84, 0x3d, 0, 1, 'x'}); // 1,000,000 bytes
    assertThat(stranger.isPutOutWhileSending(2 * BrokerLimits.FIRST_PACKET_BYTES)).isTrue();
    broker.awaitLog("its first packet is too long");
    broker.servesOn();
  }

  @Test
  void topicsTooDeepOrTooLong_areRefused() throws IOException {
    RawClient client = broker.stranger().introduced("deep");
    String deep = "u2sa" + "/x".repeat(10_000);
    client.publish(deep, COMMAND, 0);
    client.publish("u2sa/cessna/" + "x".repeat(60_000), COMMAND, 0);
    assertThat(client.subscribe("u2sa" + "/x".repeat(2_000))).isEqualTo(REFUSED);
    assertThat(client.subscribe("+/".repeat(40) + "#")).isEqualTo(REFUSED);
    broker.awaitLog("message refused, its topic is too long");
    broker.awaitLog("subscription refused, a filter is too long");
    broker.servesOn();
  }

  @Test
  void filtersThatAreNone_areRefusedOrHarmless() throws IOException {
    for (String filter : new String[] {"", "#/x", "a#", "+a/b", "//", "$SYS/#", "\u0001"}) {
      RawClient client = broker.stranger().introduced("odd");
      client.trySubscribe(filter);
    }
    broker.servesOn();
  }

  @Test
  void subscriptions_moreThanThereMayBe_areRefusedOneByOne() throws IOException {
    RawClient greedy = broker.stranger().introduced("greedy");
    int granted = 0;
    for (int i = 0; i < 300; i++) {
      granted += greedy.subscribe("u2sa/cessna/state/x" + i) == REFUSED ? 0 : 1;
    }
    assertThat(granted).isEqualTo(BrokerLimits.FILTERS_PER_CLIENT);
    broker.awaitLog("subscription refused, it has too many filters");
    broker.servesOn();
  }

  @Test
  void packetsThatU2saDoesNotUse_putTheClientOut() throws IOException {
    RawClient exactly = broker.stranger().introduced("exactly-once");
    exactly.publish(ACTUATION, COMMAND, 2);
    assertThat(exactly.isPutOut()).isTrue();
    broker.awaitLog("unexpected packet");
    RawClient first = broker.stranger();
    first.publish(ACTUATION, COMMAND, 0);
    assertThat(first.isPutOut()).isTrue();
    broker.awaitLog("the first packet is not a CONNECT");
    broker.servesOn();
  }

  @Test
  void packetsSentBeforeTheAnswerToConnect_areTaken() throws IOException {
    for (int i = 0; i < 30; i++) {
      try (RawClient hasty = new RawClient(broker.port)) {
        assertThat(hasty.introduceAndSubscribe("hasty-" + i, "u2sa/cessna/state/#")).isZero();
      }
    }
    broker.servesOn();
  }

  @Test
  void sameClientId_again_replacesTheFirst() throws IOException {
    RawClient first = broker.stranger().introduced("twin");
    RawClient second = broker.stranger().introduced("twin");
    assertThat(first.isPutOut()).isTrue();
    assertThat(second.subscribe("u2sa/cessna/state/#")).isZero();
    broker.servesOn();
  }

  @Test
  void clientThatFallsSilent_isPutOutAfterOneAndAHalfOfItsKeepAlive() throws IOException {
    RawClient silent = broker.stranger();
    assertThat(silent.keepingAlive(1).introduce("silent")).isZero();
    assertThat(silent.isPutOut()).isTrue();
    broker.servesOn();
  }

  @Test
  void connectionsThatSayNothing_moreThanThereIsRoom_doNotKeepOthersOut() throws IOException {
    for (int i = 0; i < 200; i++) {
      broker.stranger();
    }
    broker.servesOn();
    broker.awaitLog("pending connection closed");
  }

  @Test
  void clients_moreThanThereMayBe_areRefusedUntilSomeGo() throws IOException {
    for (int i = 0; i < 64; i++) {
      broker.stranger().introduced("many-" + i);
    }
    RawClient late = broker.stranger();
    assertThat(late.introduce("late")).isEqualTo(COME_AGAIN);
    broker.awaitLog("log-in refused, too many connections");
    broker.leaveStrangers();
    broker.servesOn();
  }
}
