package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.core.ConditionFactory;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.XmlConfiguration;
import org.u2sa.interfaces.communication.BrokerAccess;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.messages.MessageCodec;
import org.u2sa.messages.MessageTypes;
import org.u2sa.messages.PercentageCommand;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.EmergencyStop;

/** The embedded broker with users and TLS. */
@Timeout(60)
class SecuredBrokerTest {
  private static final MessageTypes TYPES = MessageTypes.standard();

  @TempDir static Path authorityFolder;
  @TempDir static Path otherFolder;
  private static SecurityDirectory authority;

  @TempDir Path folder;

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final RecordingReceiver inbox = new RecordingReceiver();
  private final List<Connection> connections = new ArrayList<>();
  private SecurityDirectory directory;
  private int port;
  private CommunicationManager manager;

  @BeforeAll
  static void makeAuthority() throws IOException, InterruptedException, GeneralSecurityException {
    authority = TestAuthority.in(authorityFolder);
  }

  @BeforeEach
  void start() throws IOException {
    try (ServerSocket probe = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      port = probe.getLocalPort();
    }
    directory = TestAuthority.copy(authority, folder);
    TestAuthority.addUser(directory, "sensor", "service", "cessna");
    TestAuthority.addUser(directory, "control", "control", "cessna");
    TestAuthority.addUser(directory, "safety", "safety", "cessna");
    TestAuthority.addUser(directory, "pilot", "operator", "cessna");
    TestAuthority.addUser(directory, "screen", "observer", "cessna");
    TestAuthority.addUser(directory, "boatman", "operator", "boat");
    manager = start(Map.of("SECURITY DIRECTORY", folder.toString()));
    Connection local = manager.transport().connect("Local", inbox);
    for (Channel<?> channel : Channels.all()) {
      local.subscribe(channel);
    }
    connections.add(local);
  }

  private CommunicationManager start(Map<String, Object> variables) {
    Map<String, Object> all = new HashMap<>(variables);
    all.putIfAbsent("COMMUNICATION MANAGER PORT", port);
    return CommunicationManager.start(
        "cessna", XmlConfiguration.inMemory("test", all), TYPES, log::add);
  }

  @AfterEach
  void stop() {
    connections.forEach(Connection::close);
    manager.close();
  }

  private MqttTransport transport(BrokerAccess access, String system) {
    return new MqttTransport("localhost", port, system, new MessageCodec(TYPES), access);
  }

  private BrokerAccess accessOf(String user) {
    return BrokerAccess.of(
        user,
        folder.resolve(user + ".password").toString(),
        true,
        directory.authority().toString());
  }

  private Connection connect(String user, RecordingReceiver receiver) {
    Connection connection = transport(accessOf(user), "cessna").connect("Remote", receiver);
    connections.add(connection);
    return connection;
  }

  private Connection connect(String user) {
    return connect(user, new RecordingReceiver());
  }

  private static <T extends U2SAData> T frozen(T message) {
    message.systemId("cessna");
    message.timestamp(1);
    message.freeze();
    return message;
  }

  private static ConditionFactory soon() {
    return await().atMost(Duration.ofSeconds(30));
  }

  /** Publishes until it arrives: no single message of this channel is sure to. */
  private static void awaitArrival(
      PercentageCommand command, Connection from, RecordingReceiver at) {
    soon()
        .until(
            () -> {
              from.publish(Channels.ACTUATION, command);
              return at.messages.contains(command);
            });
  }

  private void awaitLog(String... parts) {
    soon()
        .until(
            () -> log.stream().anyMatch(line -> List.of(parts).stream().allMatch(line::contains)));
  }

  @Test
  void publish_actuation_isTakenFromControlOnly() {
    PercentageCommand wrong = frozen(PercentageCommand.of("RUDDER", 99.0));
    PercentageCommand right = frozen(PercentageCommand.of("RUDDER", 1.0));
    StateInformation state = frozen(new StateInformation().sensorName("gps").x(1.0));
    Connection sensor = connect("sensor");

    sensor.publish(Channels.ACTUATION, wrong);
    sensor.publish(Channels.STATE, state);
    connect("control").publish(Channels.ACTUATION, right);

    soon().until(() -> inbox.messages.contains(right) && inbox.messages.contains(state));
    assertThat(inbox.messages).doesNotContain(wrong);
    awaitLog(
        "role service may not publish on actuation",
        "\"sensor\"",
        "127.0.0.1",
        "u2sa/cessna/actuation");
  }

  @Test
  void publish_emergencyStop_safetyMaySetAndOnlyTheOperatorClears() {
    EmergencyStop set = frozen(new EmergencyStop().active(true));
    EmergencyStop byService = frozen(new EmergencyStop().active(true).reason("no right"));
    EmergencyStop bySafety = frozen(new EmergencyStop().active(false).clears(1).reason("no right"));
    EmergencyStop byOperator = frozen(new EmergencyStop().active(false).clears(1));

    connect("sensor").publish(Channels.EMERGENCY_STOP, byService);
    Connection safety = connect("safety");
    safety.publish(Channels.EMERGENCY_STOP, bySafety);
    safety.publish(Channels.EMERGENCY_STOP, set);
    connect("pilot").publish(Channels.EMERGENCY_STOP, byOperator);

    soon().until(() -> inbox.messages.contains(set) && inbox.messages.contains(byOperator));
    assertThat(inbox.messages).doesNotContain(byService, bySafety);
    awaitLog("only an operator clears an emergency stop", "\"safety\"");
  }

  @Test
  void otherSystemsOperator_neitherCommandsNorHears() throws IOException, GeneralSecurityException {
    PercentageCommand command = frozen(PercentageCommand.of("RUDDER", 1.0));
    RecordingReceiver boatmanHears = new RecordingReceiver();
    Connection boatman =
        transport(accessOf("boatman"), Topic.ANY_SYSTEM).connect("Remote", boatmanHears);
    connections.add(boatman);
    assertThat(boatman.subscribe(Channels.ACTUATION)).isTrue();
    RecordingReceiver pilotHears = new RecordingReceiver();
    assertThat(connect("pilot", pilotHears).subscribe(Channels.ACTUATION)).isTrue();

    byte[] stop = frozen(new EmergencyStop().active(true)).serialize();
    try (RawClient cunning = new RawClient(TestAuthority.socket(directory), port)) {
      assertThat(cunning.introduce("cunning", "boatman", "boatman")).isZero();
      cunning.publish("u2sa/cessna/emergency-stop/EmergencyStop", stop, 0);
      awaitLog("message refused, it is another system", "\"boatman\"");
    }
    awaitArrival(command, connect("control"), pilotHears);

    assertThat(boatmanHears.messages).isEmpty();
    assertThat(inbox.messages).noneMatch(EmergencyStop.class::isInstance);
  }

  @Test
  void connect_withAnotherUsersClientId_isRefusedAndTheFirstStays()
      throws IOException, GeneralSecurityException {
    try (RawClient first = new RawClient(TestAuthority.socket(directory), port);
        RawClient second = new RawClient(TestAuthority.socket(directory), port)) {
      assertThat(first.introduce("twin", "sensor", "sensor")).isZero();
      assertThat(second.introduce("twin", "boatman", "boatman")).isEqualTo(2);
      assertThat(first.subscribe("u2sa/cessna/state/#")).isZero();
    }
    awaitLog("log-in refused, the client ID is another user's", "\"boatman\"");
  }

  @Test
  void connect_asAClientOfAnotherSystem_isRefused() {
    assertThatThrownBy(() -> connect("boatman"))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("Not authorized");
    awaitLog("log-in refused, it is another system", "\"boatman\"");
  }

  @Test
  void connect_observerWhoseWillItsRoleForbids_isLetInWithoutIt() {
    RecordingReceiver screenHears = new RecordingReceiver();
    PercentageCommand command = frozen(PercentageCommand.of("RUDDER", 1.0));

    assertThat(connect("screen", screenHears).subscribe(Channels.ACTUATION)).isTrue();
    awaitArrival(command, connect("control"), screenHears);
    awaitLog("will refused, role observer may not publish on health", "\"screen\"");
  }

  @Test
  void connect_wrongPassword_isRefusedAndLoggedWithUserAndAddress() throws IOException {
    Files.writeString(folder.resolve("pilot.password"), "guess\n");

    assertThatThrownBy(() -> connect("pilot"))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("ssl://localhost:" + port)
        .hasMessageContaining("Bad user name or password");

    awaitLog("log-in refused, wrong password", "\"pilot\"", "127.0.0.1");
  }

  @Test
  void connect_rightPasswordAfterAFloodOfWrongOnes_isKnownAtOnceIfItCameBefore()
      throws IOException {
    connect("pilot").close();
    BrokerAccess right = accessOf("pilot");
    Files.writeString(folder.resolve("pilot.password"), "guess\n");
    soon()
        .until(
            () -> {
              assertThatThrownBy(() -> connect("pilot")).isInstanceOf(CommunicationException.class);
              return log.stream()
                  .anyMatch(line -> line.contains("too soon after a wrong password"));
            });

    connections.add(transport(right, "cessna").connect("Remote", new RecordingReceiver()));
  }

  @Test
  void connect_withoutUser_isRefused() {
    BrokerAccess nobody = BrokerAccess.of("", "", true, directory.authority().toString());
    assertThatThrownBy(() -> transport(nobody, "cessna").connect("Remote", inbox))
        .isInstanceOf(CommunicationException.class);
    awaitLog("log-in refused, it says no user");
  }

  @Test
  void connect_withoutEncryption_isRefused() {
    assertThatThrownBy(() -> transport(BrokerAccess.open(), "cessna").connect("Remote", inbox))
        .isInstanceOf(CommunicationException.class);
  }

  @Test
  void connect_brokerOfAnotherAuthority_isNotTrusted()
      throws IOException, InterruptedException, GeneralSecurityException {
    SecurityDirectory other = TestAuthority.in(otherFolder);
    BrokerAccess access =
        BrokerAccess.of(
            "pilot",
            folder.resolve("pilot.password").toString(),
            true,
            other.authority().toString());
    assertThatThrownBy(() -> transport(access, "cessna").connect("Remote", inbox))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("PKIX");
  }

  @Test
  void connect_certificateOfAnotherName_isNotTrusted() {
    MqttTransport otherName =
        new MqttTransport("127.0.0.2", port, "cessna", new MessageCodec(TYPES), accessOf("pilot"));
    manager.close();
    manager = start(Map.of("SECURITY DIRECTORY", folder.toString(), "BIND ADDRESS", "0.0.0.0"));
    assertThatThrownBy(() -> otherName.connect("Remote", inbox))
        .isInstanceOf(CommunicationException.class)
        .hasMessageContaining("127.0.0.2");
  }

  @Test
  void removeUser_whileConnected_putsItOut() {
    RecordingReceiver pilot = new RecordingReceiver();
    connect("pilot", pilot);
    UserFile.write(directory.users(), List.of());
    soon().until(() -> pilot.troubles.stream().anyMatch(line -> line.contains("lost")));
    awaitLog("its user was changed or removed", "\"pilot\"");
  }

  @Test
  void start_onANetworkUnsecured_isRefusedUnlessSaidSo() {
    assertThatThrownBy(() -> start(Map.of("BIND ADDRESS", "0.0.0.0")))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("BIND ADDRESS 0.0.0.0")
        .hasMessageContaining("ALLOW INSECURE NETWORK");
    manager.close();
    manager = start(Map.of("BIND ADDRESS", "0.0.0.0", "ALLOW INSECURE NETWORK", true));
    awaitLog("WARNING", "0.0.0.0");
  }

  @Test
  void start_keyReadableByOthers_isRefused() throws IOException {
    manager.close();
    Files.setPosixFilePermissions(
        directory.key(), java.nio.file.attribute.PosixFilePermissions.fromString("rw-r--r--"));
    assertThatThrownBy(() -> start(Map.of("SECURITY DIRECTORY", folder.toString())))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("server-key.pem");
  }
}
