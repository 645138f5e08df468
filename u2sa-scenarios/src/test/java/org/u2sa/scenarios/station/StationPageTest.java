package org.u2sa.scenarios.station;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.eclipse.paho.client.mqttv3.MqttClient;
import org.eclipse.paho.client.mqttv3.MqttConnectOptions;
import org.eclipse.paho.client.mqttv3.MqttException;
import org.eclipse.paho.client.mqttv3.persist.MemoryPersistence;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.scenarios.run.ForeignProgram;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.NeedsProgram;
import org.u2sa.testkit.ProcessTree;
import org.u2sa.testkit.TcpRelay;

/** An operator at the page of a ground vehicle that drives, in Chromium. */
@Tag("browser")
@NeedsProgram("chromium")
@Timeout(300)
class StationPageTest {
  private static final Duration LONG = Duration.ofSeconds(90);
  private static final int WIDTH = 1400;
  private static final int HEIGHT = 900;
  private static final double MAP_CENTRE_X = (WIDTH - 400) / 2.0; // of the page beside its panel
  private static final double MAP_CENTRE_Y = 450.0;

  /** In CBOR, a service named Playback with the variables of a recording. */
  private static final String PLAYBACK =
      "\u00a2kserviceNamehPlaybackivariables\u0083"
          + "\u00a3dnamehPOSITIONevaluea0cmax\u0018d"
          + "\u00a2dnamedRATEevaluea1"
          + "\u00a2dnamefPAUSEDevalueefalse";

  @TempDir private static Path profile;
  private static HeadlessBrowser browser; // of all tests: it takes as long to start as a vehicle

  @TempDir private Path folder;

  private final int brokerPort = FreePort.find();
  private final int webPort = FreePort.find();
  private final String page = "http://127.0.0.1:" + webPort + "/";
  private Process vehicle;

  @BeforeAll
  static void startBrowser() throws IOException, InterruptedException {
    browser = new HeadlessBrowser(profile, WIDTH, HEIGHT);
  }

  @AfterAll
  static void endBrowser() {
    browser.close();
  }

  @BeforeEach
  void start() throws IOException, InterruptedException {
    Path output = folder.resolve("demo.txt");
    vehicle =
        ForeignProgram.u2sa(
            output,
            "demo",
            "ugv",
            "--realtime",
            "--port=" + brokerPort,
            "--web=" + webPort,
            "--out=" + folder.resolve("out"));
    await()
        .atMost(LONG)
        .until(() -> Files.readString(output, UTF_8).contains("Operator's page: " + page));
  }

  @AfterEach
  void end() {
    browser.leave();
    ProcessTree.kill(vehicle);
  }

  private String token() {
    return new String(LocalToken.read("127.0.0.1", brokerPort).orElseThrow());
  }

  @Test
  void operator_watchesEditsHoldsAndStops_theVehicleConfirmsEach() {
    browser.open(page + "#" + token());
    browser.awaitText("link", "link ");
    browser.awaitText("doing", "to ");
    browser.awaitText("instruments", "m/s");

    double acrossTheDateLineM =
        browser
            .evaluate(
                "import('./place.js').then(({Place}) => { const place = new Place();"
                    + " place.ofState({x: 179.9999, y: -17});"
                    + " return place.of('GLOBAL', -179.9999, -17).x; })")
            .asDouble();
    assertThat(acrossTheDateLineM).isBetween(21.0, 22.0);
    String allowed = // no service's messages must hold up an emergency stop
        browser
            .evaluate(
                """
                import('./budget.js').then(({Budget}) => {
                  const budget = new Budget();
                  return [budget.allows('objects', 919000, 0), budget.allows('state', 919000, 0),
                    budget.allows('state', 919000, 1), budget.allows('arming-state', 919000, 1),
                    budget.allows('objects', 100000, 0), budget.allows('objects', 100000, 1),
                    budget.allows('objects', 100000, 400), budget.skipped].join();
                })
                """)
            .asText();
    assertThat(allowed).isEqualTo("false,true,false,true,true,false,true,3");

    browser.press("hold");
    browser.awaitText("doing", "held at");

    browser.press("tab-mission");
    browser.press("add");
    browser.clickAt(WIDTH / 4.0, HEIGHT / 2.0);
    browser.awaitText("goals", "w1");
    browser.press("upload");
    browser.awaitText("outcome", "inserted \"w1\"");
    browser.press("add");
    browser.dragRight(WIDTH / 4.0, HEIGHT / 2.0, 8);
    browser.awaitText("goals", "changed");
    browser.press("upload");
    browser.awaitText("outcome", "updated \"w1\"");

    browser.press("tab-operate");
    browser.awaitText("doing", "held at");
    browser.press("resume");
    browser.awaitText("doing", "to ");
    browser.press("return");
    browser.awaitText("outcome", "home"); // which may be reached before the page says so
    assertThat(browser.attribute("land", "hidden")).isEmpty(); // present: no aircraft

    browser.key("Escape");
    browser.key("Escape");
    browser.awaitText("alert", "Emergency stop confirmed by");

    ProcessTree.kill(vehicle);
    browser.awaitText("link", "LINK LOST");
    assertThat(browser.requests).allMatch(url -> url.contains("//127.0.0.1:" + webPort + "/"));
    assertThat(browser.errors).filteredOn(error -> !error.contains("ERR_CONNECTION")).isEmpty();
  }

  @Test
  void orders_answeredByAnotherServiceOrWithLongStops_waitForTheirOwnAndAreSplit() {
    browser.open(page + "#" + token());
    browser.awaitText("link", "link ");
    String answer =
        browser
            .evaluate(
                """
                import('./orders.js').then(({Orders}) => {
                  const orders = new Orders({publish: () => Promise.resolve()});
                  const vehicle = {id: 'ugv', now: () => 0n};
                  const undo = {serviceName: 'Control', author: ''};
                  const result = orders.ask(vehicle, 'configuration', 'ConfigurationUndo', undo, 4000, 'Control');
                  const [requestId] = orders.pending.keys();
                  orders.answered({requestId, serviceName: 'Liar', accepted: true});
                  orders.answered({requestId, serviceName: 'Control', accepted: false});
                  return result.then(each => each.serviceName);
                })
                """)
            .asText();
    assertThat(answer).isEqualTo("Control");

    String lifted = // 64 stops with IDs as long as they may be
        browser
            .evaluate(
                """
                import('./orders.js').then(({Orders}) => {
                  let inForce = Array.from({length: 64}, (each, i) => String(i).padEnd(1000, 'x'));
                  const sent = [];
                  const publish = (system, channel, type, {lifts, timestamp}) => {
                    sent.push(timestamp + ' ' + lifts.join('').length);
                    inForce = inForce.filter(id => !lifts.includes(id));
                    return Promise.resolve();
                  };
                  const vehicle = {id: 'ugv', now: () => 7n, stops: () => ({inForce})};
                  return new Orders({publish}).clearStops(vehicle).then(() => sent.join());
                })
                """)
            .asText();
    assertThat(lifted).isEqualTo("7 12000,8 12000,9 12000,10 12000,11 12000,12 4000");
  }

  @Test
  void operator_movesAGoalAndChangesServicesInMotion_theVehicleFollowsAndSaysWhy() {
    browser.open(page + "#" + token());
    browser.awaitText("doing", "to ");

    browser.awaitText("instruments", "To goal"); // the map shows the whole mission then
    await().atMost(LONG).until(() -> browser.attribute("follow", "aria-pressed").equals("false"));
    browser.press("follow"); // its centre is the vehicle
    List.of(1, 2, 3).forEach(each -> browser.press("zoom-in")); // no goal is close by
    browser.press("hold"); // so that the goal that the new one follows is not over meanwhile
    browser.awaitText("doing", "held at");
    browser.press("tab-mission");
    browser.press("add");
    browser.clickAt(MAP_CENTRE_X + 150.0, MAP_CENTRE_Y);
    browser.awaitText("goals", "w1");
    browser.press("add");
    browser.dragRight(MAP_CENTRE_X + 150.0, MAP_CENTRE_Y, 3);
    browser.press("upload");
    browser.awaitText("outcome", "inserted \"w1\"");
    browser.press("goto");
    browser.awaitText("doing", "to w1");

    browser.press("tab-services");
    browser.awaitText("service-rows", "Control");
    browser.choose("service-rows", "Control");
    browser.awaitText("variables", "TURN GAIN");
    browser.set("TURN GAIN", "-3");
    browser.press("configuration-apply");
    browser.awaitText("outcome", "variable \"TURN GAIN\": -3");
    browser.set("TURN GAIN", "2.5");
    browser.press("configuration-apply");
    browser.awaitText("outcome", "→ 2.5; revision 1");
    browser.press("configuration-undo");
    browser.awaitText("outcome", "2.5 →");
    browser.press("service-back");

    browser.choose("service-rows", "PathPlanner");
    browser.awaitText("service-class", "VectorFieldPlanner");
    browser.press("service-swap");
    browser.press("confirm-yes");
    browser.awaitText("outcome", "PathPlanner: swapped");
    browser.awaitText("service-facts", "org.u2sa.planning.VectorFieldPlanner");
    browser.press("tab-log");
    browser.awaitText("events", "goal w1 reached");

    browser.press("tab-services");
    browser.press("service-back");
    browser.choose("service-rows", "ImuSensor");
    browser.press("service-stop");
    browser.press("confirm-yes");
    browser.awaitText("outcome", "ImuSensor has stopped");
    browser.press("estop");
    browser.awaitText("alert", "Emergency stop confirmed by");
    assertThat(browser.requests).allMatch(url -> url.contains("//127.0.0.1:" + webPort + "/"));
    assertThat(browser.errors).isEmpty();
  }

  @Test
  void editor_drawsAnAreaAndOpensAFile_theVehicleRefusesAtTheFieldAndTakesTheRest() {
    browser.open(page + "#" + token());
    browser.awaitText("instruments", "To goal");
    browser.press("hold");
    browser.awaitText("doing", "held at");
    browser.press("tab-mission");
    browser.awaitText("goal-class", "HulaHoop"); // of another module than the Mission Manager
    browser.evaluate("document.getElementById('goal-class').value = 'SearchArea'");
    browser.press("add");
    browser.clickAt(300, 300);
    browser.clickAt(500, 300);
    browser.clickAt(500, 450);
    browser.press("add");
    browser.awaitText("goal-title", "s1: SearchArea");
    browser.press("upload");
    browser.awaitText("goal-fields", "lacks <resolution>; expected a number of m");
    browser.setGoalField("resolution", "2");
    browser.press("upload");
    browser.awaitText("goal-fields", "expected 0.005…1.27 m");
    browser.setGoalField("resolution", "5 cm");
    browser.press("earlier");
    browser.press("upload");
    browser.awaitText("outcome", "inserted \"s1\"");

    browser.evaluate("document.getElementById('fence').open = true");
    browser.awaitText("fence-state", "fence.xml, margin 1.0 m");
    browser.press("fence-keepOut");
    browser.evaluate(
        "(() => { const field = document.getElementById('fence-field-area-1');"
            + " field.value = '-81.0475 29.1884; -81.0474 29.1884; -81.0474 29.1885';"
            + " field.dispatchEvent(new Event('change')); })()");
    browser.press("fence-upload");
    browser.awaitText("outcome", "fence of web page in force");
    browser.awaitText("fence-state", "In force: web page");

    String name = "<img src=x onerror=console.error(1)>";
    browser.openFile("bad.xml", "<mission>\n<waypoint>\n<colour>1</colour></waypoint></mission>");
    browser.awaitText("outcome", "bad.xml, line 3, <colour>: is not a field of Waypoint");
    browser.openFile(
        "<b>.xml",
        "<mission><home><x>-81</x><y>29</y></home><waypoint><name>"
            + name.replace("<", "&lt;")
            + "</name><x>-81.0478</x><y>29.1886</y></waypoint></mission>");
    browser.awaitText("draft", "<b>.xml: a mission of its own");
    browser.awaitText("goals", name);
    browser.press("upload");
    browser.press("confirm-yes");
    browser.awaitText("outcome", "paused at " + name);
    browser.awaitText("doing", "held at " + name);
    assertThat(browser.requests).allMatch(url -> url.contains("//127.0.0.1:" + webPort + "/"));
    assertThat(browser.errors).isEmpty();
  }

  @Test
  void messages_withoutTheirListsOrOfOtherKinds_silenceNeitherPanelNorOperator()
      throws MqttException {
    browser.open(page + "#" + token());
    browser.awaitText("doing", "to ");
    browser.press("supervise");
    MqttConnectOptions options = new MqttConnectOptions();
    options.setUserName("local");
    options.setPassword(token().toCharArray());
    AtomicInteger heartbeats = new AtomicInteger();
    try (MqttClient service =
        new MqttClient("tcp://127.0.0.1:" + brokerPort, "service", new MemoryPersistence())) {
      service.connect(options);
      service.subscribe("u2sa/ugv/operator/#", (topic, message) -> heartbeats.incrementAndGet());
      await().atMost(LONG).until(() -> heartbeats.get() > 0);

      // CBOR by hand: {serviceName: "X", mission: "m"} and {sensorName: "B", voltage: "x"}
      publish(service, "configuration/ConfigurationResponse", PLAYBACK);
      publish(service, "mission/MissionReport", "\u00a2kserviceNameaXgmissionam");
      publish(service, "power/BatteryState", "\u00a2jsensorNameaBgvoltageax");
      browser.awaitText("doing", "0/0, over"); // the report has come
      String shown = "getComputedStyle(document.getElementById('estop')).display";
      assertThat(browser.evaluate(shown).asText()).isNotEqualTo("none");
      int before = heartbeats.get();
      await().atMost(LONG).until(() -> heartbeats.get() >= before + 3);
      service.disconnect();
    }
    browser.awaitText("doing", "to "); // asked again: the Mission Manager's own
    assertThat(browser.errors).isEmpty();
  }

  private static void publish(MqttClient client, String topic, String bytes) throws MqttException {
    client.publish("u2sa/ugv/" + topic, bytes.getBytes(ISO_8859_1), 1, false);
  }

  @Test
  void link_goesDeadAndComesBack_isAnnouncedAndRecoversByItself() throws IOException {
    try (TcpRelay wire = new TcpRelay(webPort)) {
      browser.open("http://127.0.0.1:" + wire.port() + "/#" + token());
      browser.awaitText("instruments", "m/s");
      browser.awaitText("doing", "to ");
      assertThat(staleInstruments()).isZero();

      wire.goDead();
      await().atMost(LONG).until(() -> staleInstruments() > 0);
      browser.awaitText("alert", "Link lost");

      wire.restore();
      browser.awaitText("link", "link ");
      await().atMost(LONG).until(() -> staleInstruments() == 0);
      assertThat(browser.attribute("alert", "hidden")).isEmpty(); // present
    }
  }

  private int staleInstruments() {
    return browser.evaluate("document.querySelectorAll('#instruments .stale').length").asInt();
  }

  @Test
  void observer_pressesEverything_theVehicleDoesNotObey() {
    browser.open(page);
    browser.awaitText("link", "not connected"); // the script runs
    browser.press("enter");
    browser.awaitText("doing", "to ");

    browser.press("hold");
    browser.awaitText("outcome", "no answer from the vehicle");
    browser.press("estop");

    browser.awaitText("alert", "Emergency stop NOT CONFIRMED");
    browser.press("tab-services");
    browser.choose("service-rows", "PathPlanner");
    browser.awaitText("variables", "LOOK AHEAD"); // it may read
    browser.set("LOOK AHEAD", "2");
    for (String order : List.of("configuration-apply", "configuration-undo", "service-stop")) {
      browser.evaluate("document.getElementById('outcome').textContent = ''");
      browser.press(order);
      browser.pressIfShown("confirm-yes");
      browser.awaitText("outcome", "no answer from the vehicle");
    }
    browser.press("service-swap");
    browser.press("confirm-yes");
    browser.awaitText("service-facts", "org.u2sa.planning.PathPlanner ");
    assertThat(browser.text("service-rows")).doesNotContain("stopped");
    assertThat(browser.text("configuration-revision")).isEqualTo("revision 0");
    assertThat(browser.text("doing")).contains("to ");
    assertThat(browser.errors).isEmpty();
  }
}
