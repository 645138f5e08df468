package org.u2sa.trials.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.report.ReportFile;

/** The folder named by {@code --out}: it holds one run, one series of runs or one campaign. */
public final class OutputFolder {
  /** The file that identifies a campaign's folder. */
  public static final String JOURNAL = "runs.jsonl";

  private static final String LOGS = "logs";
  private static final int MAX_NAMED = 5;
  private static final Set<String> WRITTEN =
      Set.of(
          LOGS,
          "summary.json",
          "track.csv",
          "track.kml",
          "track.svg",
          "track.png",
          "recording.mcap",
          "mission.xml",
          "known.xml",
          "course.xml",
          "course.png",
          "run.gif",
          "snapshots",
          "judge.log",
          "encounters.txt",
          "flightgear",
          "changed-config",
          JOURNAL,
          "runs.csv",
          "campaign.html",
          "workers.log");

  /** Files that a run writes before it starts. */
  private static final List<String> INPUTS = List.of("mission.xml", "known.xml", "course.xml");

  private OutputFolder() {}

  /**
   * Refuses a folder with files that a run would overwrite, or of another run: the files of two
   * runs cannot be told apart afterwards. An absent folder, and one with other files, is fine.
   *
   * @throws BadInputException naming the folder and such files
   */
  public static void requireUnused(Path folder) {
    List<String> found = filesOfRuns(folder);
    if (!found.isEmpty()) {
      throw new BadInputException(
          "--out "
              + folder
              + ": holds "
              + found.stream().limit(MAX_NAMED).collect(Collectors.joining(", "))
              + (found.size() > MAX_NAMED ? " and " + (found.size() - MAX_NAMED) + " more" : "")
              + ", which this run would overwrite or be mixed with; expected an empty or new folder");
    }
  }

  /**
   * Refuses a campaign's folder that contains a run of another kind. A campaign's own folder is
   * fine: the campaign continues there.
   *
   * @throws BadInputException naming the folder and the files of the other run
   */
  public static void requireUnusedOrCampaign(Path folder) {
    if (!Files.exists(folder.resolve(JOURNAL))) {
      requireUnused(folder);
    }
  }

  private static List<String> filesOfRuns(Path folder) {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> WRITTEN.contains(name) || name.matches("run-[0-9]+"))
          .filter(name -> !name.equals(LOGS) || holdsFiles(folder.resolve(name)))
          .sorted()
          .toList();
    } catch (IOException e) {
      throw unreadable(folder, e);
    }
  }

  private static boolean holdsFiles(Path logs) {
    if (!Files.isDirectory(logs)) {
      return true;
    }
    try (Stream<Path> files = Files.list(logs)) {
      return files.anyMatch(Files::isRegularFile);
    } catch (IOException e) {
      throw unreadable(logs, e);
    }
  }

  /** Deletes what a run wrote before its start was refused, so that it can be retried. */
  static void withdraw(Path run) {
    for (String name : INPUTS) {
      try {
        Files.deleteIfExists(run.resolve(name));
      } catch (IOException e) {
        throw new BadInputException(
            "cannot delete " + run.resolve(name) + ": " + ReportFile.reason(e), e);
      }
    }
  }

  private static BadInputException unreadable(Path folder, IOException cause) {
    return new BadInputException("cannot read " + folder + ": " + ReportFile.reason(cause), cause);
  }
}
