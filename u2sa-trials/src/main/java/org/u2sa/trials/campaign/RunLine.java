package org.u2sa.trials.campaign;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import java.io.IOException;
import java.net.ProtocolException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.JsonText;

/**
 * Protocol of worker processes: one line of JSON per request and per answer. Transports treat the
 * lines as opaque.
 */
public final class RunLine {
  /** A run's files may exceed Jackson's default limits. */
  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder().maxStringLength(Integer.MAX_VALUE).build())
          .build();

  private static final String ARGUMENT = "argument";
  private static final String OUT = "out";
  private static final String KEEPS_FILES = "keepsFiles";
  private static final String SENDS_FILES = "sendsFiles";
  private static final String EXIT = "exit";
  private static final String OUTPUT = "output";
  private static final String ERRORS = "errors";
  private static final String FILES = "files";

  private RunLine() {}

  /**
   * A decoded request.
   *
   * @param arguments command-line arguments of {@code u2sa}
   * @param out output folder of the run, as seen by the process
   * @param keepsFiles whether to keep the files of a successful run
   * @param sendsFiles whether kept files are sent in the answer and removed from the folder
   */
  record Order(List<String> arguments, Path out, boolean keepsFiles, boolean sendsFiles) {}

  /**
   * Encodes a request for a process with access to the campaign's folder: files stay in place.
   *
   * @param directory the campaign's folder
   */
  static String here(RunRequest request, Path directory) {
    return line(request, directory.resolve(request.folder()).toString(), false);
  }

  /**
   * Encodes a request for a process on any host: files are sent in the answer.
   *
   * @param scratch temporary folder for them, relative to the process's working directory
   */
  public static String elsewhere(RunRequest request, String scratch) {
    return line(request, scratch + "/" + request.folder(), true);
  }

  private static String line(RunRequest request, String out, boolean sendsFiles) {
    return new JsonText()
        .put(ARGUMENT, request.arguments())
        .put(OUT, out)
        .put(KEEPS_FILES, request.keepsFiles())
        .put(SENDS_FILES, sendsFiles)
        .line();
  }

  /**
   * @throws IOException if the line is not a request
   */
  static Order order(String line) throws IOException {
    Map<String, List<String>> fields = fields(line);
    return new Order(
        fields.getOrDefault(ARGUMENT, List.of()),
        Path.of(only(fields, OUT)),
        Boolean.parseBoolean(only(fields, KEEPS_FILES)),
        Boolean.parseBoolean(only(fields, SENDS_FILES)));
  }

  /**
   * @param files the run's files packed by {@link FolderArchive}; empty if none are sent
   */
  static String answered(RunAnswer answer, byte[] files) {
    return new JsonText()
        .put(EXIT, answer.exit())
        .put(OUTPUT, answer.output())
        .put(ERRORS, answer.errors())
        .put(FILES, Base64.getEncoder().encodeToString(files))
        .line();
  }

  /**
   * Decodes an answer and unpacks its files.
   *
   * @param folder receives the files
   * @throws ProtocolException if the line is not an answer
   * @throws IOException if the files cannot be written
   */
  public static RunAnswer answer(String line, Path folder) throws IOException {
    Map<String, List<String>> fields = fields(line);
    byte[] files;
    RunAnswer answer;
    try {
      files = Base64.getDecoder().decode(only(fields, FILES));
      answer =
          new RunAnswer(
              Integer.parseInt(only(fields, EXIT)), only(fields, OUTPUT), only(fields, ERRORS));
    } catch (IllegalArgumentException e) { // NumberFormatException included
      throw malformed(e.getMessage());
    }
    if (files.length > 0) {
      FolderArchive.unpack(files, folder);
    }
    return answer;
  }

  private static ProtocolException malformed(String why) {
    return new ProtocolException("malformed line between the campaign's processes: " + why);
  }

  private static String only(Map<String, List<String>> fields, String name) throws IOException {
    List<String> values = fields.getOrDefault(name, List.of());
    if (values.size() != 1) {
      throw malformed(values.size() + " fields \"" + name + "\", expected one");
    }
    return values.get(0);
  }

  /**
   * @throws ProtocolException if the line is not JSON
   */
  private static Map<String, List<String>> fields(String line) throws IOException {
    Map<String, List<String>> fields = new HashMap<>();
    String name = "";
    try (JsonParser json = FACTORY.createParser(line)) {
      for (JsonToken token = json.nextToken(); token != null; token = json.nextToken()) {
        if (token == JsonToken.FIELD_NAME) {
          name = json.getText();
        } else if (token.isScalarValue()) {
          fields.computeIfAbsent(name, n -> new ArrayList<>()).add(json.getText());
        }
      }
    } catch (JsonProcessingException e) {
      throw malformed(e.getOriginalMessage());
    }
    return fields;
  }
}
