package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.web.SameOrigin;
import org.u2sa.core.communication.web.WebResponses;
import org.u2sa.core.communication.web.WebSite;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.contract.FunctionalityResponse;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.testkit.FreePort;

/** What browsers, and programs that pretend to be some, get at the web port. */
@Timeout(120)
class WebPortTest {
  private static final byte[] SCRIPT = "let a = 1;\n".getBytes(StandardCharsets.US_ASCII);

  private static final double PATIENCE_S = 2.0;

  private final LocalBus bus = new LocalBus("cessna");
  private final List<String> log = new CopyOnWriteArrayList<>();
  private final InetSocketAddress address = new InetSocketAddress("127.0.0.1", FreePort.find());
  private final int port = FreePort.find();
  private final String own = "http://127.0.0.1:" + port;
  private final String host = "Host: 127.0.0.1:" + port;
  private EmbeddedBroker broker;

  @BeforeEach
  void start() {
    broker =
        EmbeddedBroker.start(
            bus,
            new MessageCodec(StandardTypes.registry()),
            address,
            Optional.of(web(port, false)),
            new BrokerSecurity(null, null),
            XmlConfiguration.inMemory("test", Map.of("CLIENT PATIENCE", PATIENCE_S))
                .settings(BrokerLimits.class)
                .get(),
            log::add,
            () -> {});
  }

  static WebPort web(int port, boolean encrypted) {
    InetSocketAddress at = new InetSocketAddress("127.0.0.1", port);
    WebSite site =
        () ->
            Map.of(
                "/", new WebSite.File("text/html; charset=utf-8", "<p>".repeat(99_999).getBytes()),
                "/a.js", new WebSite.File("text/javascript; charset=utf-8", SCRIPT));
    return new WebPort(
        at, new WebResponses(site), SameOrigin.of(encrypted, at.getAddress()), encrypted);
  }

  @AfterEach
  void stop() {
    broker.close();
  }

  private WebSocketClient page() {
    return WebSocketClient.open("ws://127.0.0.1:" + port + "/mqtt", own, null);
  }

  @Test
  void get_file_isServedWithHeadersThatForbidOtherOrigins() throws IOException {
    String answer = HttpExchange.answer(port, "GET /a.js HTTP/1.1", host);

    assertThat(answer)
        .startsWith("HTTP/1.1 200 OK\r\n")
        .endsWith("\r\n\r\nlet a = 1;\n")
        .containsIgnoringCase("content-type: text/javascript; charset=utf-8\r\n")
        .contains("Content-Security-Policy: default-src 'none'; script-src 'self';")
        .contains("frame-ancestors 'none'")
        .contains("X-Content-Type-Options: nosniff\r\n")
        .contains("Cross-Origin-Resource-Policy: same-origin\r\n")
        .contains("Referrer-Policy: no-referrer\r\n")
        .doesNotContainIgnoringCase("set-cookie")
        .doesNotContainIgnoringCase("access-control-allow");
  }

  @Test
  void get_fileThatTheBrowserHas_isNotSentAgain() throws IOException {
    String first = HttpExchange.answer(port, "GET / HTTP/1.1", host, "Accept-Encoding: gzip");
    String tag = first.replaceAll("(?is).*\r\netag: ([^\r]*)\r.*", "$1");

    assertThat(first).containsIgnoringCase("content-encoding: gzip\r\n");
    assertThat(HttpExchange.answer(port, "GET / HTTP/1.1", host, "If-None-Match: " + tag))
        .startsWith("HTTP/1.1 304 Not Modified\r\n")
        .endsWith("\r\n\r\n");
  }

  @ParameterizedTest
  @CsvSource({
    "GET /, Host: evil.example, 421",
    "GET /, Host: 192.168.1.2, 421",
    "GET /, X: y, 421",
    "GET /b.js, Host: localhost, 404",
    "GET /../a.js, Host: localhost, 404",
    "GET //a.js, Host: localhost, 404",
    "POST /, Host: localhost, 405",
    "DELETE /a.js, Host: localhost, 405",
    "GET /mqtt, Host: localhost, 403",
  })
  void request_thatIsNotForAFileOfThisHost_isRefusedWithoutIt(
      String request, String header, int status) throws IOException {
    assertThat(HttpExchange.answer(port, request + " HTTP/1.1", header))
        .startsWith("HTTP/1.1 " + status + " ")
        .contains("Content-Security-Policy: default-src 'none';")
        .doesNotContain("let a");
  }

  @ParameterizedTest
  @CsvSource({
    "http://evil.example",
    "null",
    "http://127.0.0.1:1",
    "http://localhost:PORT",
    "https://127.0.0.1:PORT",
    "http://127.0.0.1:PORT.evil.example",
  })
  void webSocket_ofAnotherOrigin_isRefused(String origin) {
    String said = origin.replace("PORT", String.valueOf(port));

    assertThatThrownBy(() -> WebSocketClient.open("ws://127.0.0.1:" + port + "/mqtt", said, null))
        .isInstanceOf(CompletionException.class);
  }

  @Test
  void webSocket_withoutAnOriginOrWithTwo_isRefused() throws IOException {
    String upgrade = "Upgrade: websocket";
    String key = "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==";
    String line = "GET /mqtt HTTP/1.1";

    assertThat(HttpExchange.answer(port, line, host, upgrade, key)).startsWith("HTTP/1.1 403");
    assertThat(
            HttpExchange.answer(
                port, line, host, upgrade, key, "Origin: " + own, "Origin: http://evil.example"))
        .startsWith("HTTP/1.1 403");
  }

  @Test
  void webSocket_ofThePage_carriesMqttInPiecesOfAnySize() {
    WebSocketClient page = page();
    page.send(MqttPacketBytes.connect("web", 0), 3);
    soon().until(() -> page.connectCode() == 0);

    page.send(MqttPacketBytes.subscribe("u2sa/cessna/power/#"));
    soon().until(() -> page.received().contains("9003")); // SUBACK
    page.send(MqttPacketBytes.publish("u2sa/cessna/own/Thing", 20_000), 5_000);
    page.send(MqttPacketBytes.PINGREQ);

    soon().until(() -> page.received().endsWith("d000")); // PINGRESP
    assertThat(log).noneMatch(line -> line.contains("malformed"));
  }

  @Test
  void webSocket_ofAPageThatStopsReading_isEndedAndOthersAreServed() {
    WebSocketClient deaf = page();
    deaf.send(MqttPacketBytes.connect("deaf", 0));
    soon().until(() -> deaf.connectCode() == 0);
    deaf.stopReading();
    deaf.send(MqttPacketBytes.subscribe("u2sa/#"));
    FunctionalityResponse large = new FunctionalityResponse().serviceName("Local");
    large.publishes(Collections.nCopies(20, "x".repeat(5_000))).subscribes(List.of());
    frozen(large);
    Connection vehicle = bus.connect("Local", new RecordingReceiver());
    Channel<FunctionalityResponse> channel =
        Channel.latest("large", FunctionalityResponse.TYPE, message -> "all");

    soon()
        .until(
            () -> {
              for (int i = 0; i < 50; i++) {
                vehicle.publish(channel, large);
              }
              return log.stream().anyMatch(line -> line.contains("disconnected: it is too slow"));
            });

    WebSocketClient other = page();
    other.send(MqttPacketBytes.connect("other", 0));
    soon().until(() -> other.connectCode() == 0);
    vehicle.close();
  }

  static Stream<Consumer<java.net.http.WebSocket>> framesThatNoPageSends() {
    return Stream.of(
        socket -> socket.sendText("hello", true),
        socket -> socket.sendPing(ByteBuffer.wrap(new byte[100])),
        socket -> socket.sendBinary(ByteBuffer.wrap(new byte[] {1}), false),
        socket -> socket.sendBinary(ByteBuffer.wrap(new byte[20_000]), true));
  }

  @ParameterizedTest
  @MethodSource("framesThatNoPageSends")
  void frame_thatIsNotBinaryAndWholeAndShort_endsTheConnection(
      Consumer<java.net.http.WebSocket> sending) throws Exception {
    WebSocketClient page = page();

    sending.accept(page.socket());

    page.ended.get(30, TimeUnit.SECONDS);
  }

  @Test
  void requests_whoseAnswersNobodyReads_endTheConnectionBeforeTheyFillMemory() throws IOException {
    try (Socket deaf = new Socket()) {
      deaf.setReceiveBufferSize(8_192);
      deaf.connect(new InetSocketAddress("127.0.0.1", port));
      String request = "GET / HTTP/1.1\r\n" + host + "\r\n\r\n";
      deaf.getOutputStream().write(request.repeat(700).getBytes(StandardCharsets.US_ASCII));

      soon().until(() -> log.stream().anyMatch(line -> line.contains("without waiting for the")));
    }
  }

  @ParameterizedTest
  @CsvSource({"GET /a.js", "HEAD /", "GET /none", "POST /", "GET /mqtt", "G"})
  void requests_thatDoNotWait_areNotAnsweredBeyondTheFirst(String request) throws IOException {
    String one = request + " HTTP/1.1\r\n" + host + "\r\n\r\n";

    assertThat(HttpExchange.answers(port, one.repeat(300))).isLessThanOrEqualTo(1);
  }

  @Test
  void connections_moreThanOfOneAddress_displaceNoneOfTheMqttPort() throws IOException {
    try (RawClient operator = new RawClient(address.getPort())) {
      List<Socket> flood = new ArrayList<>();
      for (int i = 0; i <= BrokerLimits.PENDING_PER_ADDRESS; i++) {
        flood.add(new Socket("127.0.0.1", port));
      }
      soon().until(() -> log.stream().anyMatch(line -> line.contains("in favour of a newer one")));

      assertThat(operator.introduce("operator")).isZero();
      for (Socket each : flood) {
        each.close();
      }
    }
  }

  @Test
  void start_webPortTaken_namesItsVariable() {
    assertThatThrownBy(
            () ->
                EmbeddedBroker.start(
                    new LocalBus("other"),
                    new MessageCodec(StandardTypes.registry()),
                    new InetSocketAddress("127.0.0.1", FreePort.find()),
                    Optional.of(web(port, false)),
                    new BrokerSecurity(null, null),
                    XmlConfiguration.inMemory("test", Map.of()).settings(BrokerLimits.class).get(),
                    log::add,
                    () -> {}))
        .isInstanceOf(PortTakenException.class)
        .hasMessageContaining("127.0.0.1:" + port)
        .hasMessageContaining("WEB PORT sets another");
  }
}
