package org.u2sa.trials.campaign;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A child JVM that executes runs, so a crash affects no other run. Depends only on the JDK and
 * {@link WorkerMain}, so it works without our libraries on the class path. Not thread-safe.
 */
public final class WorkerProcess implements AutoCloseable {
  private final Process process;
  private final BufferedWriter asks;
  private final BufferedReader answers;

  /**
   * Starts the process.
   *
   * @param options JVM options, including {@link #javaOptions()}
   * @param classPath class path containing this program
   * @param directory its working directory
   * @param log receives its log
   */
  public WorkerProcess(
      List<String> options, String classPath, Path directory, ProcessBuilder.Redirect log)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(options);
    command.addAll(List.of("-cp", classPath, WorkerMain.class.getName()));
    process = new ProcessBuilder(command).directory(directory.toFile()).redirectError(log).start();
    asks = process.outputWriter(StandardCharsets.UTF_8);
    answers = process.inputReader(StandardCharsets.UTF_8);
  }

  /** The options with which this JVM was started. */
  public static List<String> javaOptions() {
    return ManagementFactory.getRuntimeMXBean().getInputArguments();
  }

  /**
   * Executes a run.
   *
   * @param line a request of {@link RunLine}
   * @return its answer, a line of {@link RunLine}
   * @throws IOException if the process has died
   */
  public String ask(String line) throws IOException {
    try {
      asks.write(line);
      asks.newLine();
      asks.flush();
      String answer = answers.readLine();
      if (answer != null) {
        return answer;
      }
    } catch (IOException e) {
      throw new IOException(death() + ": " + e.getMessage(), e);
    }
    throw new IOException(death());
  }

  private String death() {
    return "process " + process.pid() + " of the campaign has died";
  }

  /** Terminates the process, aborting the current run. */
  @Override
  public void close() {
    process.destroy();
  }
}
