package org.u2sa.benchmarks.fleet;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** A broker on this machine, as a process, and what it costs. */
final class BrokerProcess implements AutoCloseable {
  static final List<String> ALL = List.of("embedded", "mosquitto", "nats");

  private static final int ATTEMPTS = 300; // of 0.1 s

  private final Process process;
  private final int port;

  /** Starts one of {@link #ALL} and waits until it answers; its files go to the folder. */
  BrokerProcess(String name, Path folder) throws IOException, InterruptedException {
    port = freePort();
    process =
        new ProcessBuilder(command(name, folder))
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("broker.log").toFile())
            .start();
    for (int i = 0; !answers(); i++) {
      if (i == ATTEMPTS || !process.isAlive()) {
        process.destroy();
        throw new IOException(
            name + " does not answer: " + Files.readString(folder.resolve("broker.log")));
      }
      Thread.sleep(100);
    }
  }

  private List<String> command(String name, Path folder) throws IOException {
    Path file = folder.resolve("broker.conf");
    switch (name) {
      case "embedded":
        return List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-cp",
            System.getProperty("java.class.path"),
            EmbeddedBroker.class.getName(),
            "" + port);
      case "mosquitto":
        Files.writeString(file, "listener " + port + " 127.0.0.1\nallow_anonymous true\n");
        return List.of("mosquitto", "-c", file.toString());
      case "nats":
        Files.writeString(
            file,
            "listen: \"127.0.0.1:"
                + freePort()
                + "\"\nserver_name: benchmark\njetstream { store_dir: \""
                + folder.resolve("store")
                + "\" }\nmqtt { host: 127.0.0.1, port: "
                + port
                + " }\n");
        return List.of("nats-server", "-c", file.toString());
      default:
        throw new IllegalArgumentException("broker \"" + name + "\": expected one of " + ALL);
    }
  }

  /** Whether the broker's program is on the path; ours always is. */
  static boolean isHere(String name) {
    String program = name.equals("nats") ? "nats-server" : name;
    return name.equals("embedded")
        || Stream.of(System.getenv("PATH").split(File.pathSeparator))
            .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
  }

  private boolean answers() {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  int port() {
    return port;
  }

  /** Processor time so far [s], as exact as the system says: to 10 ms. */
  double cpuS() {
    return process.info().totalCpuDuration().map(Duration::toNanos).orElse(0L) / 1e9;
  }

  /** Memory in use [MB]. */
  double memoryMb() throws IOException {
    try (Stream<String> lines = Files.lines(Path.of("/proc", "" + process.pid(), "status"))) {
      return lines
              .filter(line -> line.startsWith("VmRSS:"))
              .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
              .findFirst()
              .orElse(0)
          / 1024.0;
    }
  }

  @Override
  public void close() throws InterruptedException {
    process.destroy();
    if (!process.waitFor(20, TimeUnit.SECONDS)) {
      process.destroyForcibly().waitFor();
    }
  }
}
