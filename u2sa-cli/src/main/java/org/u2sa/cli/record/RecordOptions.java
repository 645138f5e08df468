package org.u2sa.cli.record;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.core.launch.LaunchOptions;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.recorder.Recorder;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Recording options of a command; used as {@code @Mixin RecordOptions recording}. */
public final class RecordOptions {
  private static final String STEM = "recording";

  private static final Pattern SPLIT = Pattern.compile("(\\d+(?:\\.\\d+)?)(MB|GB|s|min)");
  private static final double MEGABYTES_PER_GIGABYTE = 1_000.0;
  private static final double SECONDS_PER_MINUTE = 60.0;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private final Map<String, Object> values = new LinkedHashMap<>();

  /** Format of the recorded messages, as on the command line. */
  enum Form {
    u2sa,
    foxglove,
    both
  }

  @Option(
      names = "--split",
      paramLabel = "SIZE|TIME",
      description = "Start another file at this size or duration, for example 500MB or 10min.")
  private void split(String text) {
    Matcher matcher = SPLIT.matcher(text);
    if (!matcher.matches() || Double.parseDouble(matcher.group(1)) == 0.0) {
      throw new ParameterException(
          command.commandLine(),
          "--split " + text + ": expected a number and MB, GB, s or min, such as 500MB or 10min");
    }
    double value = Double.parseDouble(matcher.group(1));
    switch (matcher.group(2)) {
      case "MB" -> values.put("SPLIT MEGABYTES", value);
      case "GB" -> values.put("SPLIT MEGABYTES", value * MEGABYTES_PER_GIGABYTE);
      case "s" -> values.put("SPLIT TIME", value);
      default -> values.put("SPLIT TIME", value * SECONDS_PER_MINUTE);
    }
  }

  @Option(
      names = "--keep",
      paramLabel = "N",
      description = "With --split: keep only the newest N files. Default: all.")
  private void keep(int files) {
    if (files < 1) {
      throw new ParameterException(
          command.commandLine(), "--keep " + files + ": expected 1 or more files");
    }
    values.put("KEEP", files);
  }

  @Option(
      names = "--form",
      paramLabel = "FORM",
      description =
          "What to record: u2sa, the original messages; foxglove, their views for Foxglove, "
              + "Lichtblick, Rerun and PlotJuggler; or both. Default: both.")
  private void form(Form form) {
    values.put("FORM", form.name().toUpperCase(Locale.ROOT));
  }

  boolean isAnyGiven() {
    return !values.isEmpty();
  }

  /** Variables of a recorder into this file, relative to the log folder. */
  XmlConfiguration configuration(String file) {
    if (values.containsKey("KEEP")
        && !values.containsKey("SPLIT MEGABYTES")
        && !values.containsKey("SPLIT TIME")) {
      throw new ParameterException(command.commandLine(), "--keep: requires --split");
    }
    Map<String, Object> all = new LinkedHashMap<>(values);
    all.put("FILE", file);
    return XmlConfiguration.inMemory("Recorder", all);
  }

  /** Records a run into this file, relative to the log folder. */
  void addTo(LaunchOptions launch, String file, RunFacts facts) {
    launch.beside(configuration(file), context -> new Recorder(context, facts.facts()));
  }

  /**
   * Deletes an earlier run's recording in a folder.
   *
   * @throws RunFailedException if it cannot be deleted
   */
  public static void deleteEarlier(Path folder) {
    if (!Files.isDirectory(folder)) {
      return;
    }
    try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, STEM + "*.mcap")) {
      for (Path file : files) {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new RunFailedException("cannot delete the earlier recording in " + folder, e);
    }
  }
}
