package org.u2sa.cli.terminal;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * This process's terminal in raw mode: keys are delivered as pressed, without echo; Ctrl-C still
 * interrupts. {@link #close} and the end of the program, whatever its cause, restore it.
 */
public final class RawTerminal implements AutoCloseable {
  private final String before;
  private final Thread atExit;

  private RawTerminal(String before) {
    this.before = before;
    atExit = new Thread(this::restoreAtExit, "u2sa-terminal");
    Runtime.getRuntime().addShutdownHook(atExit);
  }

  /**
   * Switches the terminal to raw mode.
   *
   * @throws IOException if standard input is not a terminal, or {@code stty} is missing
   */
  public static RawTerminal open() throws IOException {
    RawTerminal terminal = new RawTerminal(stty("-g"));
    stty("-icanon", "-echo", "min", "1", "time", "0");
    return terminal;
  }

  private static String stty(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of("stty"));
    command.addAll(Arrays.asList(arguments));
    Process process =
        new ProcessBuilder(command)
            .redirectInput(ProcessBuilder.Redirect.INHERIT)
            .redirectErrorStream(true)
            .start();
    String said =
        new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
    try {
      if (process.waitFor() != 0) {
        throw new IOException(String.join(" ", command) + ": " + said);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException(String.join(" ", command) + ": interrupted");
    }
    return said;
  }

  private void restoreAtExit() {
    try {
      stty(before);
    } catch (IOException e) {
      System.err.println("u2sa: cannot restore the terminal; run \"stty sane\": " + e.getMessage());
    }
  }

  @Override
  public void close() throws IOException {
    if (removeHook()) {
      stty(before);
    }
  }

  /** False during shutdown, when the hook restores the terminal. */
  private boolean removeHook() {
    try {
      return Runtime.getRuntime().removeShutdownHook(atExit);
    } catch (IllegalStateException e) {
      return false;
    }
  }
}
