package org.u2sa.cli.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.ObjIntConsumer;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.mqtt.ClientIds;
import org.u2sa.interfaces.mqtt.MqttClient;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Runs one Java process per service: starts and restarts them, and reports immediately when one
 * ends. Thread-safe.
 */
final class ServiceProcesses implements AutoCloseable {
  private static final long END_WITHIN_S = 5;
  private static final long RESTART_WITHIN_S = 2; // other services' restarts wait during this time

  private final ProcessCommand command;
  private final List<String> entries;
  private final Consumer<String> console;
  private final Map<String, Process> processes = new LinkedHashMap<>(); // guarded by this
  private final Map<String, Integer> failed = new LinkedHashMap<>(); // exit codes; guarded by this
  private volatile ObjIntConsumer<String> onFailure = (entry, exitCode) -> {};
  private boolean refused; // a first start failed on bad input; guarded by this
  private int handling; // number of ends and restarts being handled; guarded by this
  private volatile boolean closing;

  /** Runs these services, by simple class name; the console receives their events. */
  ServiceProcesses(ProcessCommand command, List<String> entries, Consumer<String> console) {
    this.command = command;
    this.entries = List.copyOf(entries);
    this.console = console;
  }

  /** Sets the listener for failed processes (service and exit code), called on a JVM thread. */
  void onFailure(ObjIntConsumer<String> takes) {
    onFailure = takes;
  }

  /** Starts one process per service, unless {@link #close} has been called. */
  synchronized void start() {
    for (String entry : entries) {
      try {
        start(entry, false);
      } catch (IOException e) {
        close();
        throw new UncheckedIOException(e);
      }
    }
  }

  private synchronized boolean start(String entry, boolean again) throws IOException {
    if (closing) {
      return false;
    }
    // Standard input is a pipe held by this process, so the child notices when this one ends.
    Process process =
        command
            .of(entry, again)
            .redirectOutput(ProcessBuilder.Redirect.INHERIT)
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    processes.put(entry, process);
    failed.remove(entry);
    process.onExit().thenAccept(ended -> ended(entry, ended, again));
    return true;
  }

  private void ended(String entry, Process process, boolean again) {
    int code = process.exitValue();
    boolean badly;
    synchronized (this) {
      badly = !closing && code != ExitCode.DONE && processes.get(entry) == process;
      if (badly) {
        failed.put(entry, code);
        refused |= !again && code == ExitCode.BAD_INPUT;
        handling++;
      }
      notifyAll();
    }
    if (badly) {
      try {
        console.accept("Service " + entry + " ended with exit code " + code + ".");
        onFailure.accept(entry, code);
      } finally {
        handled();
      }
    }
  }

  private synchronized void handled() {
    handling--;
    notifyAll();
  }

  synchronized boolean isAlive(String entry) {
    Process process = processes.get(entry);
    return process != null && process.isAlive();
  }

  /**
   * Ends the service's process, if alive, and starts a new one. A working process is asked to end
   * (SIGTERM) within 2 s, so that it sets its outputs to neutral and closes its files; a silent one
   * is killed.
   *
   * @param speaks whether the service is known to be working
   * @return whether it was started; false during shutdown
   * @throws IOException if the process cannot be started
   */
  boolean startProcess(String entry, boolean speaks) throws IOException, InterruptedException {
    Process old;
    synchronized (this) {
      old = processes.remove(entry); // not to be reported as ended
      handling++;
    }
    try {
      if (old != null && old.isAlive()) {
        if (speaks) {
          old.destroy();
          old.waitFor(RESTART_WITHIN_S, TimeUnit.SECONDS);
        }
        old.destroyForcibly()
            .waitFor(RESTART_WITHIN_S, TimeUnit.SECONDS); // no effect if it has ended
      }
      boolean started = start(entry, true);
      if (started) {
        console.accept("Service " + entry + " was restarted.");
      }
      return started;
    } finally {
      handled();
    }
  }

  String names() {
    return String.join(", ", entries);
  }

  /**
   * Waits until no process is left and none is being restarted, or until one rejects its input on
   * its first start, so that the system was never complete. Returns the exit codes of the failed
   * processes.
   */
  synchronized Map<String, Integer> awaitEnd() throws InterruptedException {
    while (!refused && (handling > 0 || processes.values().stream().anyMatch(Process::isAlive))) {
      wait();
    }
    return new LinkedHashMap<>(failed);
  }

  /** Whether {@link #awaitEnd} returned because of bad input. */
  synchronized boolean isRefused() {
    return refused;
  }

  /**
   * Ends all processes after a while in which services that heard an order to stop end by
   * themselves; one that was still starting has not heard it.
   */
  void endAll() throws InterruptedException {
    for (Process process : started()) {
      process.waitFor(END_WITHIN_S, TimeUnit.SECONDS);
    }
    close();
  }

  private synchronized List<Process> started() {
    return new ArrayList<>(processes.values());
  }

  /** Asks all processes to end and kills those that do not. */
  @Override
  public void close() {
    closing = true; // before locking, so that a start in progress ends
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

  /** Parameters of one service's process: {@code u2sa run --only}, with this program's own Java. */
  record ProcessCommand(
      Path file, Path logs, long seed, List<String> settings, boolean besideManager) {
    /** Process builder of a service; {@code restart} if it has already run in this run. */
    ProcessBuilder of(String service, boolean restart) {
      List<String> command = new ArrayList<>();
      command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
      command.add("-XX:+UseSerialGC");
      command.add("-Du2sa.home=" + System.getProperty("u2sa.home", ""));
      command.add(SystemClock.option());
      command.add(MqttClient.option());
      command.add("-cp");
      command.add(System.getProperty("java.class.path"));
      command.add(Main.class.getName());
      command.addAll(
          List.of(
              "run",
              file.toString(),
              "--only",
              service,
              "--supervised",
              "--logs",
              logs.toString(),
              "--seed",
              String.valueOf(seed)));
      if (restart) {
        command.add("--restart");
      }
      if (besideManager) {
        command.add("--beside-manager");
      }
      for (String setting : settings) {
        command.add("--set");
        command.add(setting);
      }
      ProcessBuilder process = new ProcessBuilder(command);
      process.environment().put(ClientIds.ENVIRONMENT, ClientIds.run());
      return process;
    }
  }
}
