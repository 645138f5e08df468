package org.u2sa.scenarios.campaign;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.scenarios.run.HomeFolder;

/**
 * A process of its own that makes runs, with this program's classes and options: one that dies
 * takes no other with it. For one thread.
 */
final class Worker implements AutoCloseable {
  private static final JsonFactory FACTORY = new JsonFactory();

  private final Process process;
  private final BufferedWriter asks;
  private final BufferedReader answers;

  /**
   * What a command came to.
   *
   * @param exit its code
   * @param output what it printed
   * @param errors what it said on standard error
   */
  record Answer(int exit, String output, String errors) {}

  /**
   * @param log takes what the process itself says
   */
  Worker(Path log) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    command.addAll(HomeFolder.javaOptions());
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.add(WorkerMain.class.getName());
    process =
        new ProcessBuilder(command)
            .redirectError(ProcessBuilder.Redirect.appendTo(log.toFile()))
            .start();
    asks = process.outputWriter(StandardCharsets.UTF_8);
    answers = process.inputReader(StandardCharsets.UTF_8);
  }

  /** Number of the process, as the system has it. */
  long pid() {
    return process.pid();
  }

  /**
   * Runs a command.
   *
   * @throws IOException if the process has died
   */
  Answer run(List<String> arguments) throws IOException {
    String line = line(arguments);
    try {
      asks.write(line);
      asks.newLine();
      asks.flush();
      String answer = answers.readLine();
      if (answer != null) {
        return answer(answer);
      }
    } catch (IOException e) {
      throw new IOException(death() + ": " + e.getMessage(), e);
    }
    throw new IOException(death());
  }

  private String death() {
    return "process " + process.pid() + " of the campaign has died";
  }

  private static String line(List<String> texts) throws IOException {
    StringWriter line = new StringWriter();
    try (JsonGenerator json = FACTORY.createGenerator(line)) {
      json.writeStartArray();
      for (String text : texts) {
        json.writeString(text);
      }
      json.writeEndArray();
    }
    return line.toString();
  }

  private static Answer answer(String line) throws IOException {
    Map<String, String> fields = new HashMap<>();
    try (JsonParser json = FACTORY.createParser(line)) {
      while (json.nextToken() != null) {
        if (json.currentToken() != JsonToken.FIELD_NAME && json.currentToken().isScalarValue()) {
          fields.put(json.currentName(), json.getText());
        }
      }
    }
    return new Answer(
        Integer.parseInt(fields.get(WorkerMain.EXIT)),
        fields.get(WorkerMain.OUTPUT),
        fields.get(WorkerMain.ERRORS));
  }

  /** Ends the process, in the midst of a run if there is one. */
  @Override
  public void close() {
    process.destroy();
  }
}
