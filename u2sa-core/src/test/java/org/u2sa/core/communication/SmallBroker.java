package org.u2sa.core.communication;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.testkit.FreePort;
import org.u2sa.testkit.ProcessTree;

/** A broker in a process of its own, with little memory or few file descriptors. */
final class SmallBroker implements AutoCloseable {
  final int port = FreePort.find();
  private final Process process;

  /**
   * @param descriptors file descriptors of the process at most
   * @param heap of the process, as Java's option -Xmx has it
   */
  SmallBroker(int descriptors, String heap) throws IOException {
    List<String> command = new ArrayList<>(List.of("sh", "-c"));
    command.add("ulimit -n " + descriptors + "; exec \"$@\"");
    command.add("sh");
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(
        List.of(
            "-Xmx" + heap,
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-XX:-MaxFDLimit",
            "-cp"));
    command.add(System.getProperty("java.class.path"));
    command.addAll(List.of(SmallBroker.class.getName(), String.valueOf(port)));
    process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String first = line(process.getInputStream());
    if (first.startsWith("MAX CLIENTS")) {
      first = line(process.getInputStream());
    }
    if (!first.equals("listening")) {
      ProcessTree.kill(process);
      throw new IOException("the broker's process: " + first);
    }
  }

  private static String line(InputStream in) throws IOException {
    StringBuilder line = new StringBuilder();
    for (int letter = in.read(); letter >= 0 && letter != '\n'; letter = in.read()) {
      line.append((char) letter);
    }
    return line.toString();
  }

  /** Ends the process and returns what it printed. */
  String output() throws IOException {
    process.getOutputStream().close();
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }

  boolean isAlive() {
    return process.isAlive();
  }

  @Override
  public void close() {
    ProcessTree.kill(process);
  }

  /** The process: ends with its input. Argument: the port. */
  public static void main(String[] arguments) throws IOException {
    Map<String, Object> variables =
        Map.of(
            "COMMUNICATION MANAGER PORT",
            Integer.parseInt(arguments[0]),
            "LOCAL COMMANDS",
            "everybody",
            "ANNOUNCE",
            "yes");
    CommunicationManager manager =
        CommunicationManager.start(
            "cessna",
            XmlConfiguration.inMemory("test", variables),
            StandardTypes.registry(),
            System.out::println);
    manager.transport().connect("Local", new RecordingReceiver()).subscribe(Channels.STOP);
    try (RawClient first = new RawClient(Integer.parseInt(arguments[0])).introduced("first")) {
      first.subscribe("u2sa/#"); // loads what a connection needs
    }
    System.out.println("listening");
    while (System.in.read() >= 0) {
      continue;
    }
    Runtime runtime = Runtime.getRuntime();
    System.out.printf(
        "heap %d of %d MB%n",
        runtime.totalMemory() - runtime.freeMemory() >> 20, runtime.maxMemory() >> 20);
    System.exit(0);
  }
}
