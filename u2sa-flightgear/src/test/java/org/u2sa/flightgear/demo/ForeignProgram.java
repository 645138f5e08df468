package org.u2sa.flightgear.demo;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Programs beside the tests' own virtual machine: Python, Mosquitto, and u2sa as a user runs it.
 */
final class ForeignProgram {
  private ForeignProgram() {}

  /**
   * What a program that ran to its end has said.
   *
   * @param exit its exit code; 127: there is no such program
   * @param output standard output and standard error
   */
  record Ended(int exit, String output) {}

  static Ended run(String... command) throws IOException, InterruptedException {
    try {
      Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
      String output = new String(process.getInputStream().readAllBytes(), UTF_8);
      return new Ended(process.waitFor(), output);
    } catch (IOException e) {
      if (command.length > 0 && e.getMessage().startsWith("Cannot run program")) {
        return new Ended(127, e.getMessage()); // as a shell answers
      }
      throw e;
    }
  }

  /** Starts a program; what it prints goes to the file. */
  static Process start(Path output, List<String> command) throws IOException {
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(output.toFile())
        .start();
  }

  /** Starts u2sa in a virtual machine of its own. */
  static Process u2sa(Path output, String... arguments) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-Djava.awt.headless=true",
                "-Du2sa.home=" + CommandLineRun.repository(),
                "-cp",
                System.getProperty("java.class.path"),
                "org.u2sa.gcs.Main"));
    command.addAll(List.of(arguments));
    return start(output, command);
  }

  /** A Python with cbor2 and paho-mqtt. Skips the test where there is none, except under CI. */
  static String python() throws IOException, InterruptedException {
    return required(List.of("python3", "/usr/bin/python3"), "-c", "import cbor2, paho.mqtt.client");
  }

  /** Mosquitto, the broker. Skips the test where it is not, except under CI. */
  static String mosquitto() throws IOException, InterruptedException {
    // Asked for help it exits with 3, or 0 in later versions; 127 is a shell's word for "not here".
    for (String program : List.of("mosquitto", "/usr/sbin/mosquitto")) {
      if (run(program, "-h").exit() != 127) {
        return program;
      }
    }
    return missing("mosquitto");
  }

  private static String required(List<String> programs, String... arguments)
      throws IOException, InterruptedException {
    for (String program : programs) {
      List<String> command = new ArrayList<>(List.of(program));
      command.addAll(List.of(arguments));
      if (run(command.toArray(new String[0])).exit() == 0) {
        return program;
      }
    }
    return missing("python3 with cbor2 and paho-mqtt");
  }

  private static String missing(String what) {
    assertThat(System.getenv("CI")).as("CI needs " + what).isNotEqualTo("true");
    assumeTrue(false, what + " is not here");
    return what;
  }

  static int freePort() throws IOException {
    try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return free.getLocalPort();
    }
  }
}
