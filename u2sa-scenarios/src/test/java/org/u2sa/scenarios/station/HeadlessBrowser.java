package org.u2sa.scenarios.station;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.WebSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.awaitility.Awaitility;
import org.u2sa.testkit.ProcessTree;

/** One page in Chromium without a screen, driven by the DevTools protocol. */
final class HeadlessBrowser implements AutoCloseable, WebSocket.Listener {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final Duration LONG = Duration.ofSeconds(60);
  private static final String NOTHING = "about:blank";

  /** What the page logged as an error, and exceptions that nobody caught. */
  final List<String> errors = new CopyOnWriteArrayList<>();

  /** Addresses that the page asked for. */
  final List<String> requests = new CopyOnWriteArrayList<>();

  private final Map<Integer, CompletableFuture<JsonNode>> pending = new ConcurrentHashMap<>();
  private final AtomicInteger lastId = new AtomicInteger();
  private final StringBuilder partial = new StringBuilder(); // used by the socket's thread only
  private final Process process;
  private final WebSocket socket;

  /**
   * @param profile new folder for the browser's files
   */
  HeadlessBrowser(Path profile, int width, int height) throws IOException, InterruptedException {
    process =
        new ProcessBuilder(
                "chromium",
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--remote-debugging-port=0",
                "--user-data-dir=" + profile,
                "--window-size=" + width + "," + height,
                NOTHING)
            .redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    Path port = profile.resolve("DevToolsActivePort");
    Awaitility.await().atMost(LONG).until(() -> Files.exists(port) && Files.size(port) > 0);
    HttpClient http = HttpClient.newHttpClient();
    URI list = URI.create("http://127.0.0.1:" + Files.readAllLines(port).get(0) + "/json/list");
    String targets =
        http.send(HttpRequest.newBuilder(list).build(), HttpResponse.BodyHandlers.ofString())
            .body();
    String page = "";
    for (JsonNode target : JSON.readTree(targets)) {
      page =
          target.get("type").asText().equals("page")
              ? target.get("webSocketDebuggerUrl").asText()
              : page;
    }
    socket = http.newWebSocketBuilder().buildAsync(URI.create(page), this).join();
    for (String domain : List.of("Page", "Runtime", "Log", "Network")) {
      send(domain + ".enable", Map.of());
    }
  }

  void open(String address) {
    send("Page.navigate", Map.of("url", address));
  }

  /** Leaves the page for an empty one, and forgets what was logged and asked for. */
  void leave() {
    open(NOTHING);
    Awaitility.await().atMost(LONG).until(() -> evaluate("location.href").asText().equals(NOTHING));
    errors.clear();
    requests.clear();
  }

  /** The value of an expression in the page. */
  JsonNode evaluate(String expression) {
    JsonNode result =
        send(
            "Runtime.evaluate",
            Map.of("expression", expression, "returnByValue", true, "awaitPromise", true));
    if (result.has("exceptionDetails")) {
      throw new IllegalStateException(expression + ": " + result.get("exceptionDetails"));
    }
    return result.path("result").path("value");
  }

  String text(String id) {
    return evaluate("document.getElementById('" + id + "')?.textContent ?? ''").asText();
  }

  String attribute(String id, String name) {
    return evaluate("document.getElementById('%s').getAttribute('%s')".formatted(id, name))
        .asText();
  }

  void awaitText(String id, String part) {
    Awaitility.await()
        .atMost(LONG)
        .pollInterval(Duration.ofMillis(100))
        .untilAsserted(() -> org.assertj.core.api.Assertions.assertThat(text(id)).contains(part));
  }

  void press(String id) {
    evaluate(click(id));
  }

  private static String click(String id) {
    return "document.getElementById('" + id + "').click()";
  }

  /** Presses a button that may not be there, such as the answer to a question. */
  void pressIfShown(String id) {
    evaluate("document.getElementById('" + id + "')?.checkVisibility() && " + click(id));
  }

  /** Presses the button with a text in an element. */
  void choose(String id, String text) {
    evaluate(
        "[...document.querySelectorAll('#%s button')].find(each => each.textContent === '%s').click()"
            .formatted(id, text));
  }

  /** Types a value into the form of a configuration. */
  void set(String variable, String value) {
    evaluate(
        ("(() => { const input = [...document.querySelectorAll('.variable')].find(each =>"
                + " each.firstChild.textContent === '%s').querySelector('input, select');"
                + " input.value = '%s'; input.dispatchEvent(new Event('input')); })()")
            .formatted(variable, value));
  }

  /** Types a value into a field of the chosen goal. */
  void setGoalField(String name, String value) {
    evaluate(
        ("(() => { const input = [...document.querySelectorAll('#goal-fields .variable')]"
                + ".find(each => each.firstChild.textContent === '%s')"
                + ".querySelector('input, select, textarea');"
                + " input.value = '%s'; input.dispatchEvent(new Event('input')); })()")
            .formatted(name, value));
  }

  /** Opens a text as a file of the operator's device. */
  void openFile(String name, String text) {
    evaluate(
        ("(() => { const files = new DataTransfer(); files.items.add(new File([%s], '%s'));"
                + " const input = document.getElementById('file'); input.files = files.files;"
                + " input.dispatchEvent(new Event('change')); })()")
            .formatted(JSON.valueToTree(text), name));
  }

  void key(String name) {
    for (String type : List.of("keyDown", "keyUp")) {
      send("Input.dispatchKeyEvent", Map.of("type", type, "key", name, "code", name));
    }
  }

  void clickAt(double x, double y) {
    mouse("mousePressed", x, y);
    mouse("mouseReleased", x, y);
  }

  /** Drags to the right in steps, as a hand does. */
  void dragRight(double x, double y, int steps) {
    mouse("mousePressed", x, y);
    for (int i = 1; i <= steps; i++) {
      mouse("mouseMoved", x + 10.0 * i, y);
    }
    mouse("mouseReleased", x + 10.0 * steps, y);
  }

  private void mouse(String type, double x, double y) {
    int held = type.equals("mouseReleased") ? 0 : 1;
    send(
        "Input.dispatchMouseEvent",
        Map.of("type", type, "x", x, "y", y, "button", "left", "buttons", held, "clickCount", 1));
  }

  private JsonNode send(String method, Map<String, Object> parameters) {
    int id = lastId.incrementAndGet();
    CompletableFuture<JsonNode> answer = new CompletableFuture<>();
    pending.put(id, answer);
    ObjectNode request = JSON.createObjectNode().put("id", id).put("method", method);
    request.set("params", JSON.valueToTree(parameters));
    socket.sendText(request.toString(), true).join();
    return answer.orTimeout(LONG.toSeconds(), TimeUnit.SECONDS).join();
  }

  @Override
  public CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
    partial.append(data);
    if (last) {
      try {
        received(JSON.readTree(partial.toString()));
      } catch (IOException e) {
        errors.add("DevTools sent no JSON: " + e.getMessage());
      }
      partial.setLength(0);
    }
    from.request(1);
    return null;
  }

  private void received(JsonNode message) {
    if (message.has("id")) {
      pending.remove(message.get("id").asInt()).complete(message.path("result"));
      return;
    }
    JsonNode parameters = message.path("params");
    switch (message.path("method").asText()) {
      case "Runtime.exceptionThrown", "Runtime.consoleAPICalled" ->
          errors.add(parameters.toString());
      case "Log.entryAdded" -> errors.add(parameters.path("entry").path("text").asText());
      case "Network.requestWillBeSent", "Network.webSocketCreated" ->
          requests.add(
              parameters.path("request").path("url").asText(parameters.path("url").asText()));
      default -> {}
    }
  }

  @Override
  public void close() {
    socket.abort();
    ProcessTree.end(process);
  }
}
