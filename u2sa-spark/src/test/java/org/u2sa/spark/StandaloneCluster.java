package org.u2sa.spark;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.u2sa.testkit.FreePort;

/** A master and workers of one core on this machine, made by {@code scripts/spark/node}. */
final class StandaloneCluster implements AutoCloseable {
  private static final String LOOPBACK = "127.0.0.1";

  private final Path directory;
  private final int port = FreePort.find();
  private final Process master;
  private final List<Process> workers = new ArrayList<>();

  /**
   * @param directory takes logs and what executors write
   */
  StandaloneCluster(Path directory, int workers) throws IOException {
    this.directory = directory;
    master = begin("master", LOOPBACK, Integer.toString(port));
    await().atMost(Duration.ofMinutes(1)).until(this::masterListens);
    for (int i = 0; i < workers; i++) {
      this.workers.add(begin("worker", LOOPBACK, address(), "1"));
    }
  }

  private Process begin(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of("sh", "../scripts/spark/node"));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("SPARK_WORKER_DIR", directory.toString());
    Path log = Files.createTempFile(directory, arguments[0], ".log");
    return builder.redirectErrorStream(true).redirectOutput(log.toFile()).start();
  }

  private boolean masterListens() {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(LOOPBACK, port), 1000);
      return true;
    } catch (IOException e) {
      return false; // not yet
    }
  }

  String address() {
    return "spark://" + LOOPBACK + ":" + port;
  }

  /** Whether a process was started by an executor of this worker. */
  boolean isOf(int worker, long pid) {
    return workers.get(worker).descendants().anyMatch(each -> each.pid() == pid);
  }

  /** Kills a worker and its executors, as a host that loses power. */
  void kill(int worker) {
    kill(workers.get(worker));
  }

  private static void kill(Process process) {
    CompletableFuture<?>[] ends =
        Stream.concat(Stream.of(process.toHandle()), process.descendants())
            .map(
                each -> {
                  each.destroyForcibly();
                  return each.onExit();
                })
            .toArray(CompletableFuture<?>[]::new);
    CompletableFuture.allOf(ends).join();
  }

  @Override
  public void close() {
    workers.forEach(StandaloneCluster::kill);
    kill(master);
  }
}
