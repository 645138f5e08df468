package org.u2sa.scenarios.campaign;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A Java of its own that makes runs: one that dies takes no other with it. Needs no class but the
 * JDK's and {@link WorkerMain}, so that it works where our libraries are not on the class path. For
 * one thread.
 */
public final class WorkerProcess implements AutoCloseable {
  private final Process process;
  private final BufferedWriter asks;
  private final BufferedReader answers;

  /**
   * Starts it.
   *
   * @param options for the virtual machine, {@link #javaOptions()} among them
   * @param classPath with this program
   * @param directory its current one
   * @param log takes what it says of itself
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

  /** The options that this virtual machine was started with. */
  public static List<String> javaOptions() {
    return ManagementFactory.getRuntimeMXBean().getInputArguments();
  }

  /** Number of the process, as the system has it. */
  long pid() {
    return process.pid();
  }

  /**
   * Makes a run.
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

  /** Ends the process, in the midst of a run if there is one. */
  @Override
  public void close() {
    process.destroy();
  }
}
