package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.net.ssl.SSLContext;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.testkit.FreePort;

/** The web port of a broker with users and TLS: who may log in by the page, and do what. */
@Timeout(120)
class SecuredWebPortTest {
  private static final MessageCodec CODEC = new MessageCodec(StandardTypes.registry());

  @TempDir Path folder;

  private final List<String> log = new CopyOnWriteArrayList<>();
  private final RecordingReceiver inbox = new RecordingReceiver();
  private final int port = FreePort.find();
  private SSLContext trusting;
  private SecurityDirectory directory;
  private EmbeddedBroker broker;
  private Connection vehicle;

  @BeforeEach
  void start() throws Exception {
    directory = TestAuthority.in(folder);
    TestAuthority.addUser(directory, "pilot", "operator", "cessna");
    TestAuthority.addUser(directory, "screen", "observer", "cessna");
    trusting = TestAuthority.trusting(directory);
    BrokerSecurity.Variables settings =
        XmlConfiguration.inMemory("test", Map.of("SECURITY DIRECTORY", folder.toString()))
            .settings(BrokerSecurity.Variables.class)
            .get();
    LocalBus bus = new LocalBus("cessna");
    broker =
        EmbeddedBroker.start(
            bus,
            CODEC,
            new InetSocketAddress("127.0.0.1", FreePort.find()),
            Optional.of(WebPortTest.web(port, true)),
            BrokerSecurity.of(settings, "127.0.0.1", port, log::add),
            XmlConfiguration.inMemory("test", Map.of()).settings(BrokerLimits.class).get(),
            log::add,
            () -> {});
    vehicle = bus.connect("Vehicle", inbox);
    vehicle.subscribe(Channels.EMERGENCY_STOP);
  }

  @AfterEach
  void stop() {
    vehicle.close();
    broker.close();
  }

  private WebSocketClient page(String user, String password) {
    WebSocketClient page =
        WebSocketClient.open(
            "wss://localhost:" + port + "/mqtt", "https://localhost:" + port, trusting);
    page.send(MqttPacketBytes.connectAs(user, password, "web-" + user));
    soon().until(() -> page.connectCode() >= 0);
    return page;
  }

  private static byte[] stop(String stopId) {
    EmergencyStop stop = new EmergencyStop().active(true).stopId(stopId);
    stop.operator("test").systemId("cessna");
    byte[] topic = "u2sa/cessna/emergency-stop/EmergencyStop".getBytes();
    byte[] payload = CODEC.encode(BrokerTraffic.frozen(stop));
    byte[] content = new byte[2 + topic.length + 2 + payload.length];
    content[1] = (byte) topic.length;
    System.arraycopy(topic, 0, content, 2, topic.length);
    content[3 + topic.length] = 1; // packet ID
    System.arraycopy(payload, 0, content, 4 + topic.length, payload.length);
    return MqttPacketBytes.packet(0x33, content); // QoS 1, retained
  }

  private boolean isStoppedBy(String stopId) {
    return inbox.messages.stream()
        .anyMatch(each -> ((EmergencyStop) each).stopId().equals(Optional.of(stopId)));
  }

  @Test
  void page_byTls_isServed() throws Exception {
    assertThat(HttpExchange.page(TestAuthority.socket(directory), port))
        .startsWith("HTTP/1.1 200 OK\r\n")
        .contains("Content-Security-Policy");
  }

  @Test
  void emergencyStop_ofAnObserver_isRefusedAndOfAnOperatorArrives() {
    WebSocketClient screen = page("screen", "screen");
    WebSocketClient pilot = page("pilot", "pilot");

    screen.send(stop("by screen"));
    soon().until(() -> screen.received().endsWith("40020001")); // acknowledged, as MQTT demands
    pilot.send(stop("by pilot"));

    soon().until(() -> isStoppedBy("by pilot"));
    assertThat(isStoppedBy("by screen")).isFalse();
    assertThat(log).anyMatch(line -> line.contains("role observer may not publish"));
  }

  @Test
  void login_wrongPassword_isRefusedUnderTheBrowsersAddress() {
    assertThat(page("pilot", "guess").connectCode()).isEqualTo(4);
    assertThat(log).anyMatch(line -> line.contains("wrong password") && line.contains("pilot"));
  }

  @Test
  void login_withoutAUser_isRefused() {
    WebSocketClient page =
        WebSocketClient.open(
            "wss://localhost:" + port + "/mqtt", "https://localhost:" + port, trusting);
    page.send(MqttPacketBytes.connect("web", 0));

    soon().until(() -> page.connectCode() == 5);
  }
}
