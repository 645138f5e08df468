package org.u2sa.core.launch;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.testkit.ForeignPrograms;

/** A Python that has cbor2 and paho-mqtt: the one on the path or the system's. */
final class Python {
  static final Path CLIENT = Paths.get("../clients/python").toAbsolutePath().normalize();

  private final String program;

  private Python(String program) {
    this.program = program;
  }

  /** Skips the test where there is none, except under CI, where it fails. */
  static Python required() {
    return new Python(
        ForeignPrograms.ofThisMachine().required("python3", "cbor2", "paho.mqtt.client"));
  }

  /** Runs in the client's folder; what it prints goes to the file. */
  Process start(File output, String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of(program));
    command.addAll(List.of(arguments));
    return new ProcessBuilder(command)
        .directory(CLIENT.toFile())
        .redirectErrorStream(true)
        .redirectOutput(output)
        .start();
  }

  /** Runs to the end, and returns exit code and output. */
  String run(String... arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(program));
    command.addAll(List.of(arguments));
    Process process =
        new ProcessBuilder(command).directory(CLIENT.toFile()).redirectErrorStream(true).start();
    String output = new String(process.getInputStream().readAllBytes(), UTF_8);
    return "exit code " + process.waitFor() + "\n" + output;
  }
}
