package org.u2sa.benchmarks.mqtt;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.file.Path;

/** A {@link Listener} in another Java virtual machine. */
final class ListenerProcess implements AutoCloseable {
  private final Process process;
  private final BufferedReader answers;
  private final PrintStream orders;

  ListenerProcess(Path progress) throws IOException {
    process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Listener.class.getName(),
                progress.toString())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    answers = new BufferedReader(new InputStreamReader(process.getInputStream()));
    orders = new PrintStream(process.getOutputStream(), true);
  }

  String obey(String order) throws IOException {
    orders.println(order);
    String answer = answers.readLine();
    if (answer == null) {
      throw new IOException("the listening process ended at \"" + order + "\"");
    }
    return answer;
  }

  @Override
  public void close() throws InterruptedException {
    orders.close(); // it ends with its input
    process.waitFor();
  }
}
