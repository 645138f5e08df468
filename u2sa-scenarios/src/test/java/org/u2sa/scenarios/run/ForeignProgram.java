package org.u2sa.scenarios.run;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.testkit.ForeignPrograms;
import org.u2sa.testkit.Repository;

/** Programs beside the tests' own virtual machine: Python, and u2sa as a user runs it. */
public final class ForeignProgram {
  private ForeignProgram() {}

  /**
   * What a program that ran to its end has said.
   *
   * @param exit its exit code
   * @param output standard output and standard error
   */
  public record Ended(int exit, String output) {}

  /** Runs a program to its end. */
  public static Ended run(String... command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), UTF_8);
    return new Ended(process.waitFor(), output);
  }

  /** Starts a program; what it prints goes to the file. */
  public static Process start(Path output, List<String> command) throws IOException {
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(output.toFile())
        .start();
  }

  /** Starts u2sa in a virtual machine of its own. */
  public static Process u2sa(Path output, String... arguments) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-Djava.awt.headless=true",
                "-Du2sa.home=" + Repository.root(),
                "-cp",
                System.getProperty("java.class.path"),
                "org.u2sa.cli.Main"));
    command.addAll(List.of(arguments));
    return start(output, command);
  }

  /** A Python with cbor2 and paho-mqtt. Skips the test where there is none, except under CI. */
  public static String python() {
    return ForeignPrograms.ofThisMachine().required("python3", "cbor2", "paho.mqtt.client");
  }
}
