package org.u2sa.trials.campaign;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.report.ReportFile;

/**
 * Results of a campaign on disk, one line per run in order of completion, so that an interrupted
 * campaign can resume. The first line identifies the campaign.
 */
final class Journal implements AutoCloseable {
  private static final JsonFactory FACTORY = new JsonFactory();

  private final Path file;
  private final BufferedWriter out;

  private Journal(Path file, BufferedWriter out) {
    this.file = file;
    this.out = out;
  }

  /**
   * Opens the file for appending, creating it if absent.
   *
   * @param campaign textual description of the campaign
   * @param inputs digests of the {@link InputFiles} and the program that its runs depend on
   * @param done receives the outcomes of earlier runs
   * @throws BadInputException if the file belongs to another campaign, or cannot be written
   */
  static Journal open(
      Path file,
      String campaign,
      SortedMap<String, String> inputs,
      List<Experiment> experiments,
      List<Outcome> done) {
    try {
      boolean isNew = !Files.exists(file) || Files.size(file) == 0;
      if (!isNew) {
        read(file, campaign, inputs, experiments, done);
      }
      Journal journal =
          new Journal(
              file,
              Files.newBufferedWriter(
                  file,
                  StandardCharsets.UTF_8,
                  StandardOpenOption.CREATE,
                  StandardOpenOption.APPEND));
      if (isNew) {
        journal.line(new JsonText().put("campaign", campaign).put("inputs", text(inputs)));
      }
      return journal;
    } catch (IOException e) {
      throw new BadInputException("cannot write to " + file + ": " + ReportFile.reason(e), e);
    }
  }

  private static void read(
      Path file,
      String campaign,
      SortedMap<String, String> inputs,
      List<Experiment> experiments,
      List<Outcome> done)
      throws IOException {
    List<String> lines = whole(file);
    Map<String, String> first =
        lines.isEmpty() ? Map.of() : fields(lines.get(0), file + ", line 1");
    String said = first.getOrDefault("campaign", "");
    if (!said.equals(campaign)) {
      throw new BadInputException(
          file
              + ": contains the campaign \""
              + said
              + "\", not \""
              + campaign
              + "\"; expected the same command, or another --out");
    }
    Optional<String> changed = InputFiles.difference(inputs(first), inputs);
    if (changed.isPresent()) {
      throw new BadInputException(
          file
              + ": was written with another content of "
              + changed.get()
              + "; expected the same files, or another --out");
    }
    for (int i = 1; i < lines.size(); i++) {
      String where = file + ", line " + (i + 1);
      Map<String, String> fields = fields(lines.get(i), where);
      int exit = number(fields, "exit", Integer.MIN_VALUE, Integer.MAX_VALUE, where);
      int run = number(fields, "run", 1, experiments.size(), where);
      if (exit != RunAnswer.LOST) {
        done.add(
            new Outcome(
                experiments.get(run - 1),
                exit,
                fields.getOrDefault("summary", ""),
                fields.getOrDefault("trouble", "")));
      }
    }
  }

  private static String text(SortedMap<String, String> inputs) {
    StringBuilder lines = new StringBuilder();
    inputs.forEach((name, digest) -> lines.append(digest).append(' ').append(name).append('\n'));
    return lines.toString();
  }

  private static Map<String, String> inputs(Map<String, String> first) {
    Map<String, String> inputs = new HashMap<>();
    for (String line : first.getOrDefault("inputs", "").split("\n")) {
      int space = line.indexOf(' ');
      inputs.put(line.substring(space + 1), line.substring(0, Math.max(space, 0)));
    }
    inputs.remove("");
    return inputs;
  }

  private static int number(
      Map<String, String> fields, String name, int min, int max, String where) {
    String text = fields.getOrDefault(name, "");
    try {
      int value = Integer.parseInt(text);
      if (value >= min && value <= max) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below, like an out-of-range number
    }
    throw new BadInputException(
        where + ", field \"" + name + "\": \"" + text + "\", expected a number " + min + "…" + max);
  }

  /** Reads the lines; truncates an incomplete last line, e.g. after a power cut. */
  private static List<String> whole(Path file) throws IOException {
    String text = Files.readString(file, StandardCharsets.UTF_8);
    int end = text.lastIndexOf('\n') + 1;
    if (end < text.length()) {
      Files.writeString(file, text.substring(0, end), StandardCharsets.UTF_8);
    }
    return new ArrayList<>(text.substring(0, end).lines().toList());
  }

  private static Map<String, String> fields(String line, String where) throws IOException {
    Map<String, String> fields = new HashMap<>();
    try (JsonParser json = FACTORY.createParser(line)) {
      while (json.nextToken() != null) {
        if (json.currentToken().isScalarValue()) {
          fields.put(String.valueOf(json.currentName()), json.getText());
        }
      }
    } catch (JsonProcessingException e) {
      throw new BadInputException(
          where
              + ": "
              + e.getOriginalMessage()
              + "; expected JSON; delete the line to repeat its run",
          e);
    }
    return fields;
  }

  /**
   * Adds a result.
   *
   * @throws RunFailedException if it cannot be written
   */
  void add(Outcome outcome) {
    try {
      line(
          new JsonText()
              .put("run", outcome.experiment().number())
              .put("exit", outcome.exit())
              .put("summary", outcome.summary())
              .put("trouble", outcome.trouble()));
    } catch (IOException e) {
      throw new RunFailedException("cannot write to " + file + ": " + ReportFile.reason(e), e);
    }
  }

  private void line(JsonText text) throws IOException {
    out.write(text.line());
    out.write('\n');
    out.flush();
  }

  @Override
  public void close() {
    try {
      out.close();
    } catch (IOException e) {
      throw new RunFailedException("cannot write to " + file + ": " + ReportFile.reason(e), e);
    }
  }
}
