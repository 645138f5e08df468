package org.u2sa.network;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/**
 * Hosts on a network of their own, made by {@code scripts/network/lan}, which takes all away again
 * when this process ends, however it ends.
 */
final class Lan implements AutoCloseable {
  private static final int CANNOT = 77;
  private static final long CLEANED_WITHIN_S = 30;

  private record Host(String address, String namespace) {}

  private final Process script;
  private final Writer orders;
  private final BufferedReader answers;
  private final Map<String, Host> hosts = new LinkedHashMap<>();
  private final String shaping;

  /** Makes the hosts; where the machine cannot, the test is skipped and says why. */
  Lan(Path repository, Path folder, String... names) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(repository.resolve("scripts/network/lan").toString());
    command.add("--shaped");
    command.addAll(List.of(names));
    Path errors = folder.resolve("lan.log");
    script = new ProcessBuilder(command).redirectError(errors.toFile()).start();
    orders = new OutputStreamWriter(script.getOutputStream(), StandardCharsets.UTF_8);
    answers =
        new BufferedReader(new InputStreamReader(script.getInputStream(), StandardCharsets.UTF_8));
    String ready = answers.readLine();
    if (ready == null) {
      Assumptions.assumeFalse(script.waitFor() == CANNOT, "no network namespaces: see " + errors);
      throw new IOException("scripts/network/lan failed: see " + errors);
    }
    String[] words = ready.split(" ");
    shaping = words[2];
    for (int i = 3; i < words.length; i++) {
      String[] parts = words[i].split("=");
      hosts.put(parts[0], new Host(parts[1], parts[2]));
    }
  }

  String address(String host) {
    return hosts.get(host).address();
  }

  String namespace(String host) {
    return hosts.get(host).namespace();
  }

  /** What delays and loses frames: netem, or relay in its stead. */
  String shaping() {
    return shaping;
  }

  /** The command that runs a program on a host; the process is that of the program itself. */
  List<String> on(String host, List<String> program) {
    List<String> command = new ArrayList<>(List.of("ip", "netns", "exec", namespace(host)));
    command.addAll(program);
    return command;
  }

  /** Takes the host's link down. */
  void cut(String host) throws IOException {
    order("cut " + host);
  }

  /** Leaves the link up and lets nothing through. */
  void silence(String host) throws IOException {
    order("silence " + host);
  }

  void mend(String host) throws IOException {
    order("mend " + host);
  }

  /** Delays and loses frames in both directions; three zeros end it. */
  void shape(String host, double delayMs, double jitterMs, double lossPercent) throws IOException {
    order("shape " + host + " " + delayMs + " " + jitterMs + " " + lossPercent);
  }

  private void order(String order) throws IOException {
    orders.write(order + "\n");
    orders.flush();
    String answer = answers.readLine();
    if (!"done".equals(answer)) {
      throw new IOException("scripts/network/lan, " + order + ": " + answer);
    }
  }

  /** kill −9 for the script, which has no time to clean up then. */
  void kill() throws InterruptedException {
    script.destroyForcibly().waitFor();
  }

  @Override
  public void close() throws IOException {
    orders.close(); // the end of its input is the end of the network
    try {
      if (!script.waitFor(CLEANED_WITHIN_S, TimeUnit.SECONDS)) {
        script.destroy();
      }
    } catch (InterruptedException e) {
      script.destroy();
      Thread.currentThread().interrupt();
    }
  }
}
