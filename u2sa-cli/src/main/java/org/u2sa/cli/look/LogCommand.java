package org.u2sa.cli.look;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.record.RecordingParts;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.recorder.mcap.McapReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa log}: merges the logs of all services of a run into one stream. */
@Command(
    name = "log",
    description = {
      "Print the logs of all services of a run, sorted by time.",
      "",
      "  ./u2sa log                              the newest run below out/",
      "  ./u2sa log --level warn --follow        warnings and errors, as they occur",
      "  ./u2sa log out/drive/logs --service Control,PathPlanner",
      "  ./u2sa log recording.mcap --tail 20     logs attached to a recording",
      "",
      "Logs are files of the host where a service runs; over the broker, ./u2sa echo conditions "
          + "and ./u2sa echo health show the condition of services. Exit code 1: no line matches."
    })
public final class LogCommand extends BaseCommand {
  private static final double FOLLOW_EVERY_S = 0.2;

  @Parameters(
      arity = "0..1",
      paramLabel = "FOLDER|RECORDING",
      description =
          "Folder or recording with the logs. Default: the most recent folder below out/.")
  private Path where;

  @Option(
      names = "--level",
      paramLabel = "LEVEL",
      defaultValue = "DEBUG",
      description = "Lowest level: ${COMPLETION-CANDIDATES}. Default: all.")
  private LogLevelEnum level;

  @Option(
      names = "--service",
      paramLabel = "NAME",
      split = ",",
      description = "Only the lines of these services.")
  private List<String> services = List.of();

  @Option(
      names = "--tail",
      paramLabel = "N",
      description = "Start with the last N lines. Default: the first line.")
  private Integer tail;

  @Option(
      names = {"-f", "--follow"},
      description = "Keep printing new lines until Ctrl-C.")
  private boolean follow;

  @Option(names = "--json", description = "Print JSON, one object per line.")
  private boolean json;

  @Override
  public Integer call() throws IOException, InterruptedException {
    Path source = where == null ? newest() : where;
    if (Files.isRegularFile(source)) {
      if (follow) {
        throw new BadInputException("--follow: " + source + " is a recording; expected a folder");
      }
      RecordingParts.othersNotRead(source).ifPresent(this::tell);
      return printed(wanted(attached(source)), source);
    }
    if (!Files.isDirectory(source)) {
      throw new BadInputException(
          source
              + ": "
              + RegularFile.problem(source).orElseThrow()
              + "; expected a folder with logs, or a recording");
    }
    LogFolder folder = new LogFolder(source);
    if (!follow) {
      return printed(wanted(folder.more()), source);
    }
    follow(folder);
    return ExitCode.DONE;
  }

  private static Path newest() throws IOException {
    return LogFolder.newestBelow(Path.of("out"))
        .orElseThrow(
            () ->
                new BadInputException(
                    "there are no logs below out/; expected the folder of a run's logs, or a recording"));
  }

  private static List<LogLine> attached(Path recording) throws IOException {
    List<LogLine> lines = new ArrayList<>();
    try (McapReader reader = McapReader.open(recording)) {
      for (String name : reader.attachmentNames()) {
        if (name.endsWith(".log")) {
          byte[] data = reader.attachment(name).orElseThrow().data();
          lines.addAll(LogLine.of(new String(data, StandardCharsets.UTF_8)));
        }
      }
    }
    lines.sort(Comparator.comparing(LogLine::time));
    return lines;
  }

  private List<LogLine> wanted(List<LogLine> all) {
    Set<String> names =
        all.stream().map(LogLine::service).collect(Collectors.toCollection(TreeSet::new));
    for (String service : services) {
      if (!follow && !names.contains(service)) {
        throw new BadInputException(
            "--service: no service \""
                + service
                + "\" has written a log; there are "
                + String.join(", ", names)
                + NearestNames.didYouMean(service, names));
      }
    }
    return all.stream()
        .filter(line -> line.level().compareTo(level) >= 0)
        .filter(line -> services.isEmpty() || services.contains(line.service()))
        .collect(Collectors.toList());
  }

  private List<LogLine> last(List<LogLine> lines) {
    if (tail == null) {
      return lines;
    }
    if (tail < 0) {
      throw new BadInputException("--tail " + tail + ": expected 0 or more");
    }
    return lines.subList(Math.max(0, lines.size() - tail), lines.size());
  }

  private int printed(List<LogLine> lines, Path source) {
    if (lines.isEmpty()) {
      throw new RunFailedException(source + ": no line of level " + level + " or above");
    }
    print(last(lines));
    return ExitCode.DONE;
  }

  private void follow(LogFolder folder) throws IOException, InterruptedException {
    print(last(wanted(folder.more())));
    Clock clock = new SystemClock();
    try (Clock.Waiter waiter = clock.newWaiter("log")) {
      while (!out().checkError()) {
        waiter.await(clock.micros() + Clock.micros(FOLLOW_EVERY_S));
        print(wanted(folder.more()));
      }
    }
  }

  private void print(List<LogLine> lines) {
    Terminal terminal = terminal();
    for (LogLine line : lines) {
      if (json) {
        print(
            new JsonText()
                .put("time", line.time())
                .put("level", line.level().name())
                .put("service", line.service())
                .put("thread", line.thread())
                .put("text", line.text())
                .line());
        continue;
      }
      String mark =
          line.level() == LogLevelEnum.ERROR ? terminal.bad("ERROR") : level(line, terminal);
      for (String part :
          (line.time() + " " + mark + " " + line.service() + ": " + line.text()).split("\n")) {
        print(part);
      }
    }
    out().flush();
  }

  private static String level(LogLine line, Terminal terminal) {
    String name = String.format("%-5s", line.level());
    return line.level() == LogLevelEnum.WARN ? terminal.bold(name) : name;
  }
}
