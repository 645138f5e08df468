package org.u2sa.gcs.view;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.StandardSocketOptions;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;

@Timeout(120)
class ViewServerTest {
  private static final String V1 = "foxglove.websocket.v1";
  private static final long MORE_THAN_BUFFERS = 64L << 20;

  private final BlockingQueue<String> remarks = new LinkedBlockingQueue<>();
  private final ViewServer server = server(0);

  private ViewServer server(int port) {
    return new ViewServer(
        new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
        "u2sa rover",
        "session",
        true,
        Set.of(),
        remarks::add);
  }

  @AfterEach
  void end() {
    server.close();
  }

  private Viewer viewer() {
    return new Viewer(server.address().getPort(), V1);
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private ViewChannel json(String topic, boolean latched) {
    return server.channel(topic, ViewChannel.JSON, "Type", () -> bytes("{}"), latched);
  }

  @ParameterizedTest
  @ValueSource(strings = {V1, "foxglove.sdk.v1"})
  void handshake_eitherSubprotocol_isAnsweredWithServerInfo(String subprotocol) throws Exception {
    try (Viewer viewer = new Viewer(server.address().getPort(), subprotocol)) {
      assertThat(viewer.subprotocol()).isEqualTo(subprotocol);
      JsonNode info = viewer.next("serverInfo");
      assertThat(info.get("name").asText()).isEqualTo("u2sa rover");
      assertThat(info.get("sessionId").asText()).isEqualTo("session");
      assertThat(info.get("capabilities").get(0).asText()).isEqualTo("time");
    }
  }

  @Test
  void handshake_unknownSubprotocol_getsNoChannels() throws Exception {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.address().getPort())) {
      socket.setSoTimeout(30_000);
      OutputStream out = socket.getOutputStream();
      out.write(
          bytes(
              "GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                  + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n"
                  + "Sec-WebSocket-Protocol: other\r\n\r\n"));
      InputStream in = socket.getInputStream();
      String all = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
      assertThat(all).contains("expected one of the subprotocols").doesNotContain("serverInfo");
    }
  }

  @Test
  void advertise_channelsBeforeAndAfterTheViewer_areBothTold() throws Exception {
    json("a", false);
    try (Viewer viewer = viewer()) {
      JsonNode first = viewer.next("advertise").get("channels");
      assertThat(first).hasSize(1);
      assertThat(first.get(0).get("topic").asText()).isEqualTo("a");
      assertThat(first.get(0).get("schemaEncoding").asText()).isEqualTo("jsonschema");
      server.channel("b", ViewChannel.PROTOBUF, "foxglove.Log", () -> new byte[] {1, 2}, false);
      JsonNode second = viewer.next("advertise").get("channels").get(0);
      assertThat(second.get("id").asInt()).isEqualTo(2);
      assertThat(Base64.getDecoder().decode(second.get("schema").asText())).containsExactly(1, 2);
    }
  }

  @Test
  void subscribe_thenUnsubscribe_getsMessagesOfThatChannelInBetween() throws Exception {
    ViewChannel a = json("a", false);
    ViewChannel b = json("b", false);
    try (Viewer viewer = viewer()) {
      viewer.next("advertise");
      viewer.send("{'op': 'subscribe', 'subscriptions': [{'id': 4000000000, 'channelId': 1}]}");
      viewer.send("{'op': 'nothing'}"); // its answer says that the subscription was read
      viewer.next("status");
      server.publish(b, 5, () -> bytes("of b"));
      server.publish(a, 0x1122334455667788L, () -> bytes("of a"));
      Viewer.Data data = viewer.nextData();
      assertThat(data.subscription()).isEqualTo(4_000_000_000L);
      assertThat(data.nanos()).isEqualTo(0x1122334455667788L);
      assertThat(data.bytes()).isEqualTo(bytes("of a"));
      viewer.send("{'op': 'unsubscribe', 'subscriptionIds': [4000000000]}");
      viewer.send("{'op': 'nothing'}");
      viewer.next("status");
      server.publish(a, 6, () -> bytes("too late"));
      server.time(7);
      assertThat(viewer.times.poll(30, TimeUnit.SECONDS)).isEqualTo(7);
      assertThat(viewer.data).isEmpty();
    }
  }

  @Test
  void subscribe_latchedChannel_getsItsLastMessage() throws Exception {
    ViewChannel latched = json("goals", true);
    server.publish(latched, 1, () -> bytes("old"));
    server.publish(latched, 2, () -> bytes("newest"));
    try (Viewer viewer = viewer()) {
      viewer.send("{'op': 'subscribe', 'subscriptions': [{'id': 7, 'channelId': 1}]}");
      assertThat(viewer.nextData().bytes()).isEqualTo(bytes("newest"));
      assertThat(viewer.data).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "{'op': 'advertise', 'channels': []}",
        "{'op': 'subscribe'}",
        "{'op': 'subscribe', 'subscriptions': [{'id': 'x', 'channelId': 1}]}",
        "{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 99}]}",
        "{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 4294967297}]}",
        "{'op': 'unsubscribe', 'subscriptionIds': [3]}",
        "no json",
        "[]"
      })
  void request_wrong_isAnsweredByStatusAndTheViewerStays(String request) throws Exception {
    json("a", true);
    try (Viewer viewer = viewer()) {
      viewer.send(request);
      assertThat(viewer.next("status").get("level").asInt()).isPositive();
      viewer.send("{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 1}]}");
      viewer.send("{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 1}]}");
      assertThat(viewer.next("status").get("message").asText()).contains("already exists");
    }
  }

  @Test
  void message_ofAViewer_isRefused() throws Exception {
    try (Viewer viewer = viewer()) {
      viewer.sendBytes(new byte[] {1, 0, 0, 0, 0, 42});
      assertThat(viewer.next("status").get("message").asText()).contains("read-only");
    }
  }

  @Test
  void publish_viewerThatDoesNotRead_losesItsOwnCountedAndNobodyElses() throws Exception {
    ViewChannel channel = json("a", false);
    Socket asleep = new Socket();
    try (Viewer awake = viewer()) {
      asleep.setReceiveBufferSize(4096);
      asleep.connect(server.address());
      asleep.getOutputStream().write(bytes(HANDSHAKE));
      readUntil(asleep, "serverInfo"); // frames before the handshake's end would be lost
      write(asleep, "{\"op\":\"subscribe\",\"subscriptions\":[{\"id\":1,\"channelId\":1}]}");
      write(asleep, "{\"op\":\"answer\"}");
      readUntil(asleep, "not served"); // so the subscription was read
      awake.send("{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 1}]}");
      byte[] large = new byte[1 << 18];
      int published = 0;
      while (published < 400) { // 100 MiB: no buffer holds them
        server.publish(channel, published++, () -> large);
        awake.data.clear();
      }
      asleep.close();
      String left = remarks.poll(30, TimeUnit.SECONDS);
      while (left != null && !left.contains(" disconnected; ")) {
        left = remarks.poll(30, TimeUnit.SECONDS);
      }
      assertThat(left).containsPattern(" [1-9]\\d* dropped because it read too slowly");
      Viewer.Data data = null;
      while (data == null || data.nanos() != 12_345) { // once it has read what it was sent before
        server.publish(channel, 12_345, () -> bytes("still served"));
        data = awake.data.poll(100, TimeUnit.MILLISECONDS);
      }
      assertThat(data.bytes()).isEqualTo(bytes("still served"));
    }
  }

  private static final String HANDSHAKE =
      "GET / HTTP/1.1\r\nHost: a\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
          + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\nSec-WebSocket-Version: 13\r\n"
          + "Sec-WebSocket-Protocol: "
          + V1
          + "\r\n\r\n";

  @ParameterizedTest
  @ValueSource(ints = {0x1, 0x9}) // texts, each answered by a status; pings, each by a pong
  void request_viewerThatNeverReads_isNotReadFromEither(int opcode) throws Exception {
    try (SocketChannel asleep = SocketChannel.open();
        Selector selector = Selector.open()) {
      asleep.setOption(StandardSocketOptions.SO_RCVBUF, 4096);
      asleep.connect(server.address());
      asleep.write(ByteBuffer.wrap(bytes(HANDSHAKE)));
      readUntil(asleep.socket(), "serverInfo");
      byte[] payload = bytes("{\"op\":\"" + "x".repeat(110) + "\"}");
      ByteBuffer frames = ByteBuffer.allocate(100 * (6 + payload.length));
      while (frames.hasRemaining()) {
        frames.put((byte) (0x80 | opcode)).put((byte) (0x80 | payload.length));
        frames.putInt(0).put(payload);
      }
      asleep.configureBlocking(false);
      asleep.register(selector, SelectionKey.OP_WRITE);
      long written = 0;
      while (written < MORE_THAN_BUFFERS && selector.select(2_000) > 0) {
        selector.selectedKeys().clear();
        frames.rewind().position((int) (written % frames.capacity()));
        written += asleep.write(frames);
      }
      assertThat(written).isLessThan(MORE_THAN_BUFFERS);
    }
  }

  @Test
  void connect_withoutHandshake_isLimited() throws Exception {
    List<Socket> idle = new ArrayList<>();
    try {
      int closed = 0;
      for (int i = 0; i < 80; i++) {
        idle.add(new Socket(InetAddress.getLoopbackAddress(), server.address().getPort()));
      }
      for (Socket socket : idle.subList(64, 80)) {
        socket.setSoTimeout(30_000);
        closed += socket.getInputStream().read() < 0 ? 1 : 0;
      }
      assertThat(closed).isEqualTo(16);
    } finally {
      for (Socket socket : idle) {
        socket.close();
      }
    }
  }

  @Test
  void hasRoomFor_topicsWithoutEnd_isLimitedAndSaidOnce() {
    for (int i = 0; i < 2_048; i++) {
      assertThat(server.hasRoomFor("topic" + i)).isTrue();
      json("topic" + i, false);
    }
    assertThat(server.hasRoomFor("one more")).isFalse();
    assertThat(server.hasRoomFor("and another")).isFalse();
    assertThat(server.hasRoomFor("topic7")).isTrue();
    assertThat(remarks).containsExactly("more than 2048 topics: further ones are not shown");
  }

  /** A text frame of at most 125 bytes, masked by zeros. */
  private static void write(Socket socket, String text) throws IOException {
    byte[] payload = bytes(text);
    byte[] frame = new byte[6 + payload.length];
    frame[0] = (byte) 0x81;
    frame[1] = (byte) (0x80 | payload.length);
    System.arraycopy(payload, 0, frame, 6, payload.length);
    socket.getOutputStream().write(frame);
  }

  private static void readUntil(Socket socket, String text) throws IOException {
    socket.setSoTimeout(30_000);
    StringBuilder read = new StringBuilder();
    while (read.indexOf(text) < 0) {
      int next = socket.getInputStream().read();
      assertThat(next).as(read.toString()).isNotNegative();
      read.append((char) next);
    }
  }

  @Test
  void bind_portThatIsTaken_saysSo() {
    assertThatThrownBy(() -> server(server.address().getPort()))
        .isInstanceOf(RunFailedException.class)
        .hasMessageContaining("cannot listen on");
  }

  @Test
  void feed_message_isJsonOnItsTopicAndItsViews() throws Exception {
    ViewFeed feed = new ViewFeed(server, "rover", true);
    StateInformation state = new StateInformation().sensorName("e").x(8.0).y(50.0).psi(1.0);
    state.timestamp(5L);
    feed.take(Channels.STATE, state, 5_000);
    feed.take(Channels.GOALS, new GoalList().goals(List.of()), 6_000);
    try (Viewer viewer = viewer()) {
      JsonNode channels = viewer.next("advertise").get("channels");
      assertThat(channels.findValuesAsText("topic"))
          .containsExactly(
              "u2sa/rover/state/StateInformation",
              "/rover/location",
              "/rover/pose",
              "/rover/transform",
              "u2sa/rover/goals/GoalList");
      assertThat(channels.get(1).get("schemaName").asText()).isEqualTo("foxglove.LocationFix");
      assertThat(channels.get(0).get("schema").asText()).contains("\"unit\":\"rad\"");
      viewer.send(
          "{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 1}, {'id': 2, 'channelId': 5}]}");
      assertThat(viewer.nextData().subscription()).isEqualTo(2); // goals latch
      feed.take(Channels.STATE, state, 7_000);
      assertThat(new String(viewer.nextData().bytes(), StandardCharsets.UTF_8))
          .contains("\"x\":8.0", "\"timestamp\":5");
    }
  }

  @Test
  void feed_listOfPoints_isOfObjectsInSchemaAndMessage() throws Exception {
    ViewFeed feed = new ViewFeed(server, "rover", false);
    PlannedPath path = new PlannedPath().planner("GRID").status(PathStatus.FOLLOWED);
    path.timestamp(5L);
    feed.take(Channels.PLANS, path.points(List.of(Point.of(1.5, 2.0, 0.0))), 5_000);
    try (Viewer viewer = viewer()) {
      JsonNode channel = viewer.next("advertise").get("channels").get(0);
      assertThat(channel.get("schema").asText()).contains("\"items\":{\"type\":\"object\"");
      viewer.send("{'op': 'subscribe', 'subscriptions': [{'id': 1, 'channelId': 1}]}");
      assertThat(new String(viewer.nextData().bytes(), StandardCharsets.UTF_8))
          .contains("\"points\":[{\"x\":1.5,\"y\":2.0,\"z\":0.0}]");
    }
  }

  @Test
  void feed_messageThatCannotBeShown_isReportedAndTheNextOneIsShown() throws Exception {
    ViewFeed feed = new ViewFeed(server, "rover", true);
    StateInformation state = new StateInformation().sensorName("e").x(8.0).y(50.0).psi(1.0);
    feed.take(Channels.STATE, state, 5_000);
    RangeScan scan = new RangeScan().sensorName("s").referenceFrame(ReferenceFrame.GLOBAL);
    feed.take(Channels.SCANS, scan.y(1e9).maxRange(9.0), 6_000);
    assertThat(remarks.poll(60, TimeUnit.SECONDS))
        .startsWith("a message on u2sa/rover/scans/RangeScan cannot be shown, 1 so far: ")
        .contains("latitude");

    feed.take(Channels.GOALS, new GoalList().goals(List.of()), 7_000);
    try (Viewer viewer = viewer()) {
      assertThat(viewer.next("advertise").get("channels").findValuesAsText("topic"))
          .contains("u2sa/rover/goals/GoalList");
    }
  }
}
