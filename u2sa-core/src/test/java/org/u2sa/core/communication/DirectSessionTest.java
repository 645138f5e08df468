package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.mqtt.MqttClient;

/** Our own client with brokers that are slow, or none. */
@Timeout(60)
class DirectSessionTest {
  private static final int CONNECT = 0x10;
  private static final int PINGREQ = 0xc0;
  private static final int LONGER_THAN_KEEP_ALIVE_MS = 2_500;
  private static final byte[] CONNACK = {0x20, 2, 0, 0};

  private final ServerSocket broker = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
  private final RecordingReceiver inbox = new RecordingReceiver();
  private final CompletableFuture<Connection> opening =
      CompletableFuture.supplyAsync(
          () ->
              TestManager.transport(broker.getLocalPort())
                  .by(MqttClient.DIRECT)
                  .waiting(0.0)
                  .connect("Early", inbox));

  DirectSessionTest() throws IOException {}

  @AfterEach
  void close() throws IOException {
    broker.close();
  }

  /** Reads a short packet. Returns its first byte. */
  private static int read(Socket socket) throws IOException {
    DataInputStream in = new DataInputStream(socket.getInputStream());
    int head = in.readUnsignedByte();
    int length = in.readUnsignedByte();
    if (length > 0x7f) {
      length = (length & 0x7f) + (in.readUnsignedByte() << 7);
    }
    in.readNBytes(length);
    return head;
  }

  @Test
  void open_brokerIsSlowToAnswer_saysNothingBeforeAndAsksAfterwards() throws Exception {
    try (Socket socket = broker.accept()) {
      assertThat(read(socket)).isEqualTo(CONNECT);
      socket.setSoTimeout(LONGER_THAN_KEEP_ALIVE_MS);
      assertThatThrownBy(() -> read(socket)).isInstanceOf(SocketTimeoutException.class);

      socket.setSoTimeout(0);
      socket.getOutputStream().write(CONNACK);

      Connection connection = opening.get();
      assertThat(read(socket)).isEqualTo(PINGREQ);
      connection.close();
    }
  }

  @Test
  void publish_brokerHasFallenSilent_findsTheLinkDeadWhileItSends() throws Exception {
    try (Socket socket = broker.accept()) {
      socket.getOutputStream().write(CONNACK); // and never a word again
      Connection connection = opening.get();

      BrokerTraffic.soon()
          .until(
              () -> {
                connection.publish(Channels.ACTUATION, BrokerTraffic.command(1.0));
                return !inbox.troubles.isEmpty();
              });

      assertThat(inbox.troubles.get(0)).endsWith("lost: the broker does not answer");
      connection.close();
    }
  }

  @Test
  void open_whatAnswersIsNoBroker_fails() throws Exception {
    try (Socket socket = broker.accept()) {
      socket.getOutputStream().write(new byte[] {CONNECT, 0}); // which no broker says

      assertThatThrownBy(opening::get)
          .hasMessageContaining("no Communication Manager at tcp://127.0.0.1:")
          .hasMessageContaining("the broker sent a packet of type 1");
    }
  }
}
