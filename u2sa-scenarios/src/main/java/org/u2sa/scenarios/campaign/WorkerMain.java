package org.u2sa.scenarios.campaign;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.gcs.Main;
import org.u2sa.interfaces.JsonText;

/**
 * Process that runs commands of {@code u2sa} one after the other, for a {@link Worker}: each line
 * of standard input is a JSON list of arguments, each line of standard output tells what came of
 * them. It ends when its input does.
 */
final class WorkerMain {
  static final String EXIT = "exit";
  static final String OUTPUT = "output";
  static final String ERRORS = "errors";

  private static final JsonFactory FACTORY = new JsonFactory();

  private WorkerMain() {}

  public static void main(String[] none) throws IOException {
    PrintStream answers = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    System.setOut(System.err); // nothing but answers goes there
    BufferedReader asked =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    for (String line = asked.readLine(); line != null; line = asked.readLine()) {
      StringWriter output = new StringWriter();
      StringWriter errors = new StringWriter();
      int exit =
          Main.run(
              new PrintWriter(output), new PrintWriter(errors), texts(line).toArray(String[]::new));
      answers.println(
          new JsonText()
              .put(EXIT, exit)
              .put(OUTPUT, output.toString())
              .put(ERRORS, errors.toString())
              .line());
    }
    System.exit(0); // whatever thread a demo left behind
  }

  private static List<String> texts(String line) throws IOException {
    List<String> texts = new ArrayList<>();
    try (JsonParser json = FACTORY.createParser(line)) {
      while (json.nextToken() != null) {
        if (json.currentToken() == JsonToken.VALUE_STRING) {
          texts.add(json.getText());
        }
      }
    }
    return texts;
  }
}
