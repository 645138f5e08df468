package org.u2sa.gcs.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.gcs.ExitCode;
import org.u2sa.gcs.Main;

/** One Java process a service, each {@code u2sa run --only}. */
final class ServiceProcesses implements AutoCloseable {
  private static final long END_WITHIN_S = 5;

  private final SystemFile file;
  private final Path logs;
  private final long seed;
  private final List<String> settings;
  private final Map<String, Process> processes = new LinkedHashMap<>();
  private volatile boolean closing;

  ServiceProcesses(SystemFile file, Path logs, long seed, List<String> settings) {
    this.file = file;
    this.logs = logs;
    this.seed = seed;
    this.settings = settings;
  }

  /** Starts one process a service, unless {@link #close} was called meanwhile. */
  synchronized void start() {
    for (SystemFile.Entry entry : file.services()) {
      if (closing) {
        return;
      }
      try {
        processes.put(
            entry.simpleName(),
            new ProcessBuilder(command(entry.simpleName())).inheritIO().start());
      } catch (IOException e) {
        close();
        throw new UncheckedIOException(e);
      }
    }
  }

  private List<String> command(String service) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.add("-XX:+UseSerialGC");
    command.add("-Du2sa.home=" + System.getProperty("u2sa.home", ""));
    command.add("-cp");
    command.add(System.getProperty("java.class.path"));
    command.add(Main.class.getName());
    command.addAll(
        List.of(
            "run",
            file.file().toString(),
            "--only",
            service,
            "--logs",
            logs.toString(),
            "--seed",
            String.valueOf(seed)));
    for (String setting : settings) {
      command.add("--set");
      command.add(setting);
    }
    return command;
  }

  String names() {
    return String.join(", ", processes.keySet());
  }

  /** Waits for all, and returns the exit codes of those that did not end well. */
  Map<String, Integer> awaitEnd() throws InterruptedException {
    Map<String, Integer> failed = new LinkedHashMap<>();
    for (Map.Entry<String, Process> process : processes.entrySet()) {
      int code = process.getValue().waitFor();
      if (code != ExitCode.DONE && !closing) {
        failed.put(process.getKey(), code);
      }
    }
    return failed;
  }

  private synchronized List<Process> started() {
    return List.copyOf(processes.values());
  }

  /** Asks all processes to end, and ends those that do not. */
  @Override
  public void close() {
    closing = true; // before the lock, so that a start in progress ends
    List<Process> all = started();
    all.forEach(Process::destroy);
    try {
      for (Process process : all) {
        if (!process.waitFor(END_WITHIN_S, TimeUnit.SECONDS)) {
          process.destroyForcibly();
        }
      }
    } catch (InterruptedException e) {
      all.forEach(Process::destroyForcibly);
      Thread.currentThread().interrupt();
    }
  }
}
