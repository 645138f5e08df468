package org.u2sa.gcs.ros;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.core.communication.bridge.ClientBridge;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.FreePort;

/** What ROS tools get at the port, and what they may do there. */
@Timeout(120)
class RosbridgeServerTest {
  private final int brokerPort = FreePort.find();
  private final int port = FreePort.find();
  private final List<String> log = new CopyOnWriteArrayList<>();
  private final BlockingQueue<U2SAData> heard = new LinkedBlockingQueue<>();
  private final CommunicationManager manager =
      CommunicationManager.start(
          "rover",
          XmlConfiguration.inMemory(
              "test", Map.of("COMMUNICATION MANAGER PORT", brokerPort, "ROSBRIDGE PORT", port)),
          StandardTypes.registry(),
          log::add);
  private final Connection vehicle =
      manager
          .transport()
          .connect(
              "Vehicle",
              new Receiver() {
                @Override
                public void receive(Channel<?> channel, U2SAData message) {
                  heard.add(message);
                }

                @Override
                public void trouble(String what) {
                  throw new AssertionError(what);
                }
              });

  private static final class StoppedClock implements Clock {
    @Override
    public long micros() {
      return 1_000_000L;
    }

    @Override
    public Waiter newWaiter(String name) {
      throw new IllegalStateException(name + " does not wait");
    }
  }

  @AfterEach
  void end() {
    manager.close();
  }

  private void publish(Channel<?> channel, U2SAData message, long micros) {
    message.systemId("rover");
    message.timestamp(micros);
    message.freeze();
    vehicle.publish(channel, message);
  }

  private void publishState(long micros) {
    StateInformation state = new StateInformation().sensorName("Estimator");
    publish(Channels.STATE, state.x(8.0).y(50.0).z(100.0).psi(0.0).xDot(2.0), micros);
  }

  /** Publishes states until one arrives, as subscribing takes a moment. */
  private JsonNode firstAfterStates(RosClient client) throws InterruptedException {
    JsonNode first = null;
    for (long micros = 1_500_000; first == null; micros += 50_000) {
      publishState(micros);
      first = client.texts.poll(20, TimeUnit.MILLISECONDS);
    }
    return first;
  }

  private RosClient operator() {
    String token = new String(LocalToken.read("127.0.0.1", brokerPort).orElseThrow());
    return with("local:" + token);
  }

  private RosClient with(String userAndPassword) {
    String coded =
        Base64.getEncoder().encodeToString(userAndPassword.getBytes(StandardCharsets.UTF_8));
    return new RosClient(port, builder -> builder.header("Authorization", "Basic " + coded));
  }

  @ParameterizedTest
  @CsvSource({
    "nav_msgs/Odometry, secs, nsecs",
    "nav_msgs/msg/Odometry, sec, nanosec",
    "'', sec, nanosec"
  })
  void subscribe_eitherSpellingOfTheType_hasTimesInThatSpelling(
      String type, String seconds, String nanoseconds) throws Exception {
    try (RosClient client = new RosClient(port)) {
      client.send("{'op':'subscribe','topic':'odom','type':'" + type + "'}");

      JsonNode published = firstAfterStates(client);

      assertThat(published.get("topic").asText()).isEqualTo("odom");
      JsonNode stamp = published.get("msg").get("header").get("stamp");
      long nanos = stamp.get(seconds).asLong() * 1_000_000_000L + stamp.get(nanoseconds).asLong();
      assertThat(nanos % 50_000_000L).isZero();
      assertThat(nanos).isGreaterThanOrEqualTo(1_500_000_000L);
      JsonNode pose = published.get("msg").get("pose").get("pose").get("position");
      assertThat(pose.get("x").asDouble()).isZero();
    }
  }

  @Test
  void subscribe_lateForARetainedGrid_getsItOnceTheMapHasItsOrigin() throws Exception {
    OccupancyGrid grid =
        new OccupancyGrid()
            .anchor(ReferenceFrame.GLOBAL, Point.of(8.0, 50.0, 100.0))
            .corner(-1.0, 0.0)
            .resolution(0.5)
            .cells(2, new byte[] {OccupancyGrid.UNKNOWN, 127});
    publish(Channels.GRID, grid, 1_000_000);
    try (RosClient client = new RosClient(port)) {
      client.send("{'op':'subscribe','topic':'/odom'}");
      firstAfterStates(client);
      client.send("{'op':'subscribe','topic':'/map'}");

      JsonNode map;
      do {
        map = client.next("publish");
      } while (!map.get("topic").asText().equals("/map"));

      assertThat(map.get("msg").get("data").toString()).isEqualTo("[-1,100]");
      assertThat(map.get("msg").get("info").get("origin").get("position").get("x").asDouble())
          .isEqualTo(-1.0);
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{'op':'subscribe','topic':'/nothing'} | topic \"/nothing\" does not exist",
        "{'op':'subscribe','topic':'/odom','type':'nav_msgs/Path'} | is of type nav_msgs/msg/Odometry",
        "{'op':'subscribe','topic':'/odom','compression':'png'} | compression \"png\": expected none",
        "{'op':'subscribe','topic':'/odom','fragment_size':1000} | fragment_size: messages are sent whole",
        "{'op':'subscribe','topic':'/odom','throttle_rate':-1} | \"throttle_rate\": expected 0",
        "{'op':'subscribe'} | \"topic\": expected a text",
        "{'op':'fragment','id':'1'} | \"fragment\" is not served",
        "{'op':'advertise','topic':'/odom','type':'nav_msgs/Odometry'} | published by the vehicle",
        "{'op':'publish','topic':'/u2sa/arming','msg':{'arms':true}} | has no field \"arms\"",
        "{'op':'publish','topic':'/u2sa/stop','msg':{'type':'Waypoint','uid':'1'}} | does not carry a Waypoint",
        "{'op':'auth','mac':'1','client':'a'} | MACs of rosauth are not accepted",
        "{'topic':'/odom'} | \"op\": expected a text",
        "not JSON | operation, line 1",
      })
  void take_whatIsWrong_isAnsweredWithTheReason(String operation, String reason) throws Exception {
    try (RosClient client = operator()) {
      client.send(operation.replace("'vehicle''s", "vehicle's"));
      assertThat(client.nextStatus()).contains(reason);
      assertThat(client.call("/rosapi/get_ros_version", "{}").get("version").asInt()).isEqualTo(2);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"/u2sa/emergency_stop", "u2sa/emergency_stop"})
  void publish_orderOfAnOperator_reachesTheVehicle(String topic) throws Exception {
    vehicle.subscribe(Channels.EMERGENCY_STOP);
    try (RosClient client = operator()) {
      client.send(
          "{'op':'publish','topic':'"
              + topic
              + "','msg':{'active':true,'operator':'Ann','reason':'test'}}");

      EmergencyStop stop = (EmergencyStop) heard.poll(30, TimeUnit.SECONDS);
      assertThat(stop.active()).isTrue();
      assertThat(stop.systemId()).isEqualTo("rover");
    }
  }

  @Test
  void auth_userAndPasswordInAnOperation_actsAsThatUser() throws Exception {
    vehicle.subscribe(Channels.EMERGENCY_STOP);
    String token = new String(LocalToken.read("127.0.0.1", brokerPort).orElseThrow());
    try (RosClient client = new RosClient(port)) {
      client.send("{'op':'auth','user':'local','password':'" + token + "'}");
      client.send("{'op':'publish','topic':'/u2sa/emergency_stop','msg':{'active':true}}");
      assertThat(heard.poll(30, TimeUnit.SECONDS)).isInstanceOf(EmergencyStop.class);
    }
  }

  /** The broker judges last wills when a client connects. */
  @Test
  void call_withoutALogIn_leavesTheBrokerNothingToComplainOf() throws Exception {
    try (RosClient client = new RosClient(port)) {
      client.call("/rosapi/get_param_names", "{}");
    }
    assertThat(log).noneMatch(line -> line.contains("refused"));
  }

  @Test
  void publish_withoutALogIn_isRefusedWithTheReasonAndReachesNobody() throws Exception {
    vehicle.subscribe(Channels.EMERGENCY_STOP);
    try (RosClient client = new RosClient(port);
        RosClient operator = operator()) {
      client.send(
          "{'op':'publish','topic':'/u2sa/emergency_stop','msg':{'active':true,'reason':'a'}}");
      assertThat(client.nextStatus()).contains("without a log-in this connection only listens");
      JsonNode set = client.call("/rosapi/set_param", "{'name':'/Control/GAIN','value':'1'}");
      assertThat(set.asText()).contains("orders need the role operator");
      operator.send(
          "{'op':'publish','topic':'/u2sa/emergency_stop','msg':{'active':true,'reason':'b'}}");
      EmergencyStop stop = (EmergencyStop) heard.poll(30, TimeUnit.SECONDS);
      assertThat(stop.reason()).isEqualTo("b");
    }
  }

  @Test
  void publish_whatServicesSay_isRefusedToOperatorsToo() throws Exception {
    try (RosClient client = operator()) {
      client.send(
          "{'op':'publish','topic':'/u2sa/state','msg':{'type':'StateInformation','x':1.0}}");
      assertThat(client.nextStatus()).contains("published by the vehicle");
      client.send(
          "{'op':'publish','topic':'/u2sa/actuation','msg':{'type':'PercentageCommand','actuatorName':'a','percentage':100}}");
      assertThat(client.nextStatus()).contains("published by the vehicle");
    }
  }

  @Test
  void connect_wrongPassword_isToldAndDisconnected() throws Exception {
    try (RosClient client = with("local:wrong")) {
      assertThat(client.nextStatus()).contains("Communication Manager");
      assertThat(client.isClosed()).isTrue();
    }
  }

  @Test
  void call_listings_answerAsRosapiDoes() throws Exception {
    try (RosClient client = new RosClient(port)) {
      JsonNode topics = client.call("/rosapi/topics", "{}");
      assertThat(topics.get("topics")).hasSameSizeAs(topics.get("types"));
      assertThat(client.call("/rosapi/topic_type", "{'topic':'/fix'}").get("type").asText())
          .isEqualTo("sensor_msgs/msg/NavSatFix");
      assertThat(client.call("/rosapi/topics_for_type", "{'type':'nav_msgs/Path'}").toString())
          .isEqualTo("{\"topics\":[\"/plan\"]}");
      JsonNode raw = client.call("/rosapi/topics_and_raw_types", "[]");
      assertThat(raw.get("typedefs_full_text").get(0).asText())
          .contains("MSG: geometry_msgs/TwistWithCovariance\ngeometry_msgs/Twist twist\n");
      JsonNode details = client.call("/rosapi/message_details", "{'type':'nav_msgs/msg/Path'}");
      assertThat(details.get("typedefs").get(0).get("fieldnames").toString())
          .isEqualTo("[\"header\",\"poses\"]");
      assertThat(client.call("/rosapi/nothing", "{}").asText()).contains("does not exist");
      assertThat(client.call("/rosapi/topic_type", "{}").asText())
          .isEqualTo("argument \"topic\": expected a text");
    }
  }

  @Test
  void take_hostileInput_endsOrRefusesThatClientOnly() throws Exception {
    try (RosClient hostile = new RosClient(port);
        RosClient other = new RosClient(port)) {
      hostile.send("{'op':" + "[".repeat(100) + "]".repeat(100) + "}");
      assertThat(hostile.nextStatus()).contains("nested more than");
      hostile.sendBytes(new byte[] {1, 2, 3});
      assertThat(hostile.nextStatus()).contains("binary");
      for (int i = 0; i < 257; i++) {
        hostile.send("{'op':'subscribe','id':'s" + i + "','topic':'/clock'}");
      }
      assertThat(hostile.nextStatus()).containsAnyOf("256 subscriptions", "too many operations");
      hostile.flood("{'op':'" + "a".repeat(1 << 17) + "'}");
      assertThat(hostile.isClosed()).isTrue();
      other.send("{'op':'subscribe','topic':'/clock'}");
      assertThat(firstAfterStates(other).get("msg").get("clock").get("sec").asLong()).isPositive();
    }
  }

  /**
   * Without the passing of time the allowance is not refilled. The reason may be lost with the
   * connection, of which the server leaves the rest unread.
   */
  @Test
  void take_moreThanItsAllowance_endsThatClient() throws Exception {
    int other = FreePort.find();
    ClientBridge.Setting setting =
        new ClientBridge.Setting(
            new InetSocketAddress("127.0.0.1", other),
            new MqttTransport(
                "127.0.0.1", brokerPort, "rover", new MessageCodec(StandardTypes.registry())),
            Optional.empty(),
            user -> false,
            log::add);
    try (ClientBridge server = new RosbridgeServer(setting, new StoppedClock());
        RosClient flood = new RosClient(other)) {
      String padding = " ".repeat(120_000);
      for (int i = 0; i < 40; i++) {
        flood.flood("{'op':'set_level'" + padding + "}");
      }
      assertThat(flood.isClosed()).as("by " + server).isTrue();
    }
  }

  /** Small objects take fifty bytes for each of their two characters. */
  @Test
  void take_fortyThousandValues_isRefusedBeforeTheyTakeMemory() throws Exception {
    String values = "{},".repeat(40_000) + "{}";
    try (RosClient client = new RosClient(port)) {
      client.send(
          "{'op':'call_service','service':'/rosapi/get_param_names','args':{'a':["
              + values
              + "]}}");
      assertThat(client.nextStatus()).contains("too many values");
    }
  }

  /** Whoever waits for an answer of the vehicle's has one such text in memory, not thirty. */
  @Test
  void take_longOperationsWhileOneWaits_areDroppedBeyondTheClientsShare() throws Exception {
    String call =
        "{'op':'call_service','service':'/rosapi/has_param','args':{'name':'/none/none'}%s}";
    // The longest there may be: on any heap, fewer of them fit than calls may wait.
    String longest = call.formatted(" ".repeat(131_000 - call.length()));
    RosBacklog backlog = RosBacklog.incoming();
    int fitting = 0;
    while (backlog.hold(longest.length())) {
      fitting++;
    }
    try (RosClient client = new RosClient(port)) {
      for (int i = 0; i <= fitting + 1; i++) {
        client.flood(longest);
      }
      assertThat(client.nextStatus()).contains("too many operations at once");
    }
  }

  @Test
  void connect_operatorWhenSilentOnesHaveAllPlaces_comesInsteadOfTheOldest() throws Exception {
    List<RosClient> silent = new CopyOnWriteArrayList<>();
    try {
      for (int i = 0; i < 16; i++) {
        silent.add(new RosClient(port));
      }
      try (RosClient operator = operator()) {
        assertThat(operator.call("/rosapi/services", "{}").get("services")).isNotEmpty();
        assertThat(silent.get(0).isClosed()).isTrue();
        assertThat(silent.get(1).call("/rosapi/services", "{}").get("services")).isNotEmpty();
      }
    } finally {
      silent.forEach(RosClient::close);
    }
  }

  /** Each has ten seconds: whoever opens many must not keep the others out for as long. */
  @Test
  void connect_moreHandshakesThanThereMayBe_theOldestEnds() throws Exception {
    List<Socket> silent = new ArrayList<>();
    try {
      for (int i = 0; i < 40; i++) {
        silent.add(new Socket("127.0.0.1", port));
      }
      try (RosClient client = new RosClient(port)) {
        assertThat(client.call("/rosapi/services", "{}").get("services")).isNotEmpty();
      }
      assertThat(silent.get(0).getInputStream().read()).isEqualTo(-1);
    } finally {
      for (Socket each : silent) {
        each.close();
      }
    }
  }

  @Test
  void connect_moreThanSixteen_isRefusedUntilOneLeaves() throws Exception {
    List<RosClient> clients = new CopyOnWriteArrayList<>();
    try {
      for (int i = 0; i < 17; i++) {
        clients.add(new RosClient(port));
      }
      assertThat(clients.get(16).isClosed()).isTrue();
      assertThat(clients.get(15).call("/rosapi/services", "{}").get("services")).isNotEmpty();
    } finally {
      clients.forEach(RosClient::close);
    }
  }
}
