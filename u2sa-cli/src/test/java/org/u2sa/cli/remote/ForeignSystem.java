package org.u2sa.cli.remote;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.u2sa.cli.Main;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.ProcessTree;

/** A system that runs in a Java process of its own, started by {@code u2sa run}. */
public final class ForeignSystem implements AutoCloseable {
  private final Process process;
  private final int port;

  private ForeignSystem(Process process, int port) {
    this.process = process;
    this.port = port;
  }

  /**
   * Starts the system and returns when its services run.
   *
   * @param directory for its files
   * @param services the full names of their classes
   */
  public static ForeignSystem start(Path directory, String systemId, String... services) {
    int port = FreePort.find();
    try {
      Files.writeString(
          directory.resolve("Manager.xml"),
          "<configuration><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
              + port
              + "\"/></configuration>");
      StringBuilder text = new StringBuilder("<system id=\"" + systemId + "\">\n");
      text.append("<communication configuration=\"Manager.xml\"/>\n");
      for (String service : services) {
        text.append("<service class=\"").append(service).append("\"/>\n");
      }
      Path file =
          Files.writeString(directory.resolve("system.xml"), text.append("</system>\n").toString());
      return start(file, port);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Starts a system, or a part of it, and returns when its services run. Logs go beside its file.
   *
   * @param port of its broker
   * @param arguments of {@code u2sa run}, further than the file
   */
  public static ForeignSystem start(Path file, int port, String... arguments) throws IOException {
    ForeignSystem system = new ForeignSystem(launch(file, arguments), port);
    system.awaitRunning();
    return system;
  }

  private static Process launch(Path file, String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-Xmx128m", "-cp"));
    command.add(System.getProperty("java.class.path"));
    command.add(Main.class.getName());
    command.addAll(
        List.of("run", file.toString(), "--logs", file.resolveSibling("logs").toString()));
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command).redirectErrorStream(true).start();
  }

  private void awaitRunning() throws IOException {
    BufferedReader words =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    StringBuilder said = new StringBuilder();
    for (String line = words.readLine(); line != null; line = words.readLine()) {
      said.append(line).append('\n');
      if (line.startsWith("System ")) {
        return; // what it says afterwards fits into the pipe
      }
    }
    throw new IllegalStateException("the system did not start:\n" + said);
  }

  /** {@code --broker} of it. */
  public String broker() {
    return "127.0.0.1:" + port;
  }

  /** Its broker's TCP port. */
  public int port() {
    return port;
  }

  /** Waits for its end, at most 20 s; returns whether it ended. */
  public boolean awaitEnd() throws InterruptedException {
    return process.waitFor(20, TimeUnit.SECONDS);
  }

  @Override
  public void close() {
    ProcessTree.end(process);
  }
}
