package org.u2sa.scenarios.vrx;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa demo vrx-table}: runs a folder's worlds and compares with published scores. */
@Command(
    name = "vrx-table",
    description = {
      "Do the VRX tasks of all worlds in a folder, and print the scores beside the published ones.",
      "",
      "Worlds of other tasks are omitted. The files of each run are in a subfolder of --out."
    })
final class VrxTable implements Callable<Integer> {
  private static final Pattern SCORE = Pattern.compile("\"score\"\\s*:\\s*([-+.0-9eE]+)");
  private static final Pattern CONTACTS = Pattern.compile("\"contacts\"\\s*:\\s*(\\d+)");

  /** VRX 2019, rehearsal, another version of the simulator: best score of each run. */
  private static final String PUBLISHED =
      """
      published (VRX 2019, rehearsal; older simulator, two thrusters that turn), best team of each run:
        stationkeeping  0.14  0.27  1.26  19.56  4.41  5.59; best team's mean 7.35
        wayfinding      0     0.03  0.18  0.03   0.03  0.03
        path            finished by two teams
        wildlife, dock  not part of it""";

  @Parameters(
      paramLabel = "FOLDER",
      description = "Folder with worlds of VRX, searched to any depth.")
  private Path folder;

  @Option(
      names = "--task",
      description = "Only this task: one of ${COMPLETION-CANDIDATES}. Default: all.")
  private VrxTask only; // null: all

  @Option(names = "--runs", paramLabel = "N", description = "Runs per world. Default: 1.")
  private int runs = 1;

  @Option(names = "--seed", paramLabel = "N", description = "Seed of the first run. Default: 1.")
  private long seed = 1;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "Folder for the runs.")
  private Path out;

  @Spec private CommandSpec command;

  private record Score(VrxTask task, double score, int contacts) {}

  @Override
  public Integer call() throws IOException {
    if (runs < 1) {
      throw new ParameterException(
          command.commandLine(), "--runs " + runs + ": expected 1 or more");
    }
    PrintWriter to = command.commandLine().getOut();
    List<Score> all = new ArrayList<>();
    to.printf("%-44s %-14s %s%n", "world", "task", "scores");
    for (Path world : worlds()) {
      Optional<VrxTask> task = VrxWorldReader.task(world);
      if (task.isEmpty() || only != null && task.get() != only) {
        continue;
      }
      String name = world.getFileName().toString().replace(".sdf", "");
      List<Score> scores = new ArrayList<>();
      for (int i = 0; i < runs; i++) {
        scores.add(run(world, task.get(), seed + i, out.resolve(name + "-" + (seed + i))));
      }
      all.addAll(scores);
      to.println(line(name, task.get(), scores) + ofAll(world, task.get()));
      to.flush();
    }
    if (all.isEmpty()) {
      throw new BadInputException(folder + ": contains no world with a task that the demo runs");
    }
    for (VrxTask task : VrxTask.values()) {
      total(task, all).ifPresent(to::println);
    }
    PUBLISHED.lines().forEach(to::println);
    to.flush();
    return ExitCode.DONE;
  }

  private List<Path> worlds() throws IOException {
    if (!Files.isDirectory(folder)) {
      throw new BadInputException(folder + ": no such folder; expected one with VRX worlds");
    }
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().endsWith(".sdf"))
          .filter(file -> !file.getFileName().toString().equals("model.sdf"))
          .sorted()
          .toList();
    }
  }

  private static Score run(Path world, VrxTask task, long seed, Path directory) throws IOException {
    StringWriter said = new StringWriter();
    String[] arguments = {
      "demo",
      "vrx",
      "--port",
      "0",
      "--world",
      world.toString(),
      "--seed",
      "" + seed,
      "--out",
      directory.toString()
    };
    Main.run(new PrintWriter(said), new PrintWriter(said), arguments);
    Path summary = directory.resolve("summary.json");
    if (!Files.exists(summary)) {
      throw new RunFailedException(world + ": " + said);
    }
    String text = Files.readString(summary);
    Matcher score = SCORE.matcher(text);
    Matcher contacts = CONTACTS.matcher(text);
    if (!score.find() || !contacts.find()) {
      throw new RunFailedException(summary + ": has no score");
    }
    return new Score(task, Double.parseDouble(score.group(1)), Integer.parseInt(contacts.group(1)));
  }

  private static String line(String name, VrxTask task, List<Score> scores) {
    StringBuilder line = new StringBuilder();
    line.append(
        String.format(Locale.ROOT, "%-44s %-14s", name, task.name().toLowerCase(Locale.ROOT)));
    int contacts = 0;
    for (Score each : scores) {
      line.append(String.format(Locale.ROOT, task.isFine() ? " %6.3f" : " %6.1f", each.score()));
      contacts += each.contacts();
    }
    return line + (contacts > 0 ? "  contacts " + contacts : "");
  }

  /** Maximum score of a path (11 per gate) and of a dock; unit of times. */
  private static String ofAll(Path world, VrxTask task) {
    return switch (task) {
      case PATH -> " of " + PathJudge.most(VrxWorldReader.read(world).gates().size());
      case DOCK ->
          String.format(Locale.ROOT, " of %.0f", VrxWorldReader.read(world).docking().most());
      case WILDLIFE -> " s";
      case STATIONKEEPING, WAYFINDING -> "";
    };
  }

  private static Optional<String> total(VrxTask task, List<Score> all) {
    List<Score> scores = all.stream().filter(each -> each.task() == task).toList();
    if (scores.isEmpty()) {
      return Optional.empty();
    }
    double mean = scores.stream().mapToDouble(Score::score).average().orElseThrow();
    double least = scores.stream().mapToDouble(Score::score).min().orElseThrow();
    double most = scores.stream().mapToDouble(Score::score).max().orElseThrow();
    return Optional.of(
        String.format(
            Locale.ROOT,
            "%-16s mean %.3f, worst %.3f, %d runs, %d contacts",
            task.name().toLowerCase(Locale.ROOT),
            mean,
            task.isMoreBetter() ? least : most,
            scores.size(),
            scores.stream().mapToInt(Score::contacts).sum()));
  }
}
