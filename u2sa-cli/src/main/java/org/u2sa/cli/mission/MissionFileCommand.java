package org.u2sa.cli.mission;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.gcs.plan.FenceAreas;
import org.u2sa.gcs.plan.GoalItems;
import org.u2sa.gcs.plan.ItemGoals;
import org.u2sa.gcs.plan.PlanXml;
import org.u2sa.gcs.plan.QgcPlan;
import org.u2sa.gcs.plan.StationPlan;
import org.u2sa.gcs.plan.WaypointList;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.RegularFile;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Converts mission files to and from those of other ground stations. */
abstract class MissionFileCommand extends BaseCommand {
  private static final long LONGEST = 16L << 20; // bytes
  private static final String PLAN = ".plan";

  @Parameters(paramLabel = "FILE", description = "The file to convert.")
  private Path file;

  @Option(
      names = {"-o", "--out"},
      paramLabel = "PATH",
      description = "File to write. Default: beside FILE, with its name.")
  private Path out;

  @Option(
      names = "--fence",
      paramLabel = "PATH",
      description = "Fence file that belongs to the mission.")
  private Path fence;

  @Option(
      names = "--lossy",
      description =
          "Leave out and list everything that the other format cannot express; otherwise refuse.")
  private boolean lossy;

  private final List<String> lost = new ArrayList<>();

  Path file() {
    return file;
  }

  Optional<Path> fence() {
    return Optional.ofNullable(fence);
  }

  List<String> lost() {
    return lost;
  }

  Path target(String suffix) {
    String name = file.getFileName().toString().replaceFirst("\\.[A-Za-z]+$", "");
    return out == null ? file.resolveSibling(name + suffix) : out;
  }

  String content() throws IOException {
    RegularFile.require(file, "a mission");
    if (Files.size(file) > LONGEST) {
      throw new BadInputException(file + ": expected a file of at most 16 MiB");
    }
    try {
      return Files.readString(file, StandardCharsets.UTF_8);
    } catch (CharacterCodingException e) {
      throw new BadInputException(file + ": expected UTF-8 text", e);
    }
  }

  /** Rejects losses unless --lossy is given. */
  void settle() {
    if (!lost.isEmpty() && !lossy) {
      throw new BadInputException(
          file
              + ": cannot be converted without loss (--lossy leaves it out):\n  "
              + String.join("\n  ", lost));
    }
    lost.forEach(each -> tell("left out: " + each));
  }

  void write(Path path, String text, String what) {
    ReportFile.writeText(path, writer -> writer.write(text));
    print(path + " (" + what + ")");
  }

  /** {@code u2sa mission export}. */
  @Command(
      name = "export",
      description = {
        "Write a mission file as QGroundControl's .plan, or as QGC WPL 110.",
        "",
        "  ./u2sa mission export mission.xml",
        "  ./u2sa mission export mission.xml --out mission.waypoints",
        "",
        "A file whose name ends with .plan is a plan; any other is a list of waypoints. docs/missions.md describes the formats."
      })
  static final class Export extends MissionFileCommand {
    @Override
    public Integer call() {
      Mission mission = Mission.load(file());
      Path target = target(PLAN);
      boolean isPlan = target.toString().endsWith(PLAN);
      Optional<XmlElement> fence = fence().map(path -> XmlReader.read(path, "fence"));
      StationPlan plan =
          new StationPlan(
              mission.home().flatMap(this::place),
              GoalItems.of(mission.goals(), lost(), lost()).items(),
              fence.map(root -> FenceAreas.read(root, lost())).orElse(List.of()),
              fence.map(FenceAreas::rally).orElse(List.of()));
      if (mission.timeLimit().isPresent()) {
        lost().add("mission: timeLimit " + mission.timeLimit().getAsDouble() + " s");
      }
      if (!isPlan && fence.isPresent()) {
        lost().add("fence: a waypoint list cannot contain one");
      }
      settle();
      write(
          target,
          isPlan ? QgcPlan.text(plan) : WaypointList.text(plan),
          plan.items().size() + " items");
      return ExitCode.DONE;
    }

    private Optional<StationPlan.Place> place(Home home) {
      if (!home.referenceFrame().equals(ReferenceFrame.GLOBAL)) {
        lost().add("home: is in " + home.referenceFrame() + ", not in Global");
        return Optional.empty();
      }
      if (home.headingRad().isPresent()) {
        lost().add("home: psi " + Math.toDegrees(home.headingRad().getAsDouble()) + " deg");
      }
      return Optional.of(new StationPlan.Place(home.x(), home.y(), home.z()));
    }
  }

  /** {@code u2sa mission import}. */
  @Command(
      name = "import",
      description = {
        "Write QGroundControl's .plan, or a list of waypoints (QGC WPL 110), as a mission file.",
        "",
        "  ./u2sa mission import survey.plan",
        "  ./u2sa mission import route.waypoints --out mission.xml",
        "",
        "Altitudes relative to home require the home altitude. For a plan with a fence or rally points, give --fence."
      })
  static final class Import extends MissionFileCommand {
    @Override
    public Integer call() throws IOException {
      String text = content();
      String origin = file().toString();
      StationPlan plan =
          WaypointList.isOne(text)
              ? WaypointList.read(origin, text)
              : QgcPlan.read(origin, text, lost());
      List<GoalInformation> goals = goals(plan);
      if (goals.isEmpty()) {
        throw new BadInputException(file() + ": contains no position to go to");
      }
      String fenceText = "";
      boolean hasFence = !plan.areas().isEmpty() || !plan.rally().isEmpty();
      if (hasFence && fence().isPresent()) {
        fenceText = PlanXml.fence("", plan.areas(), plan.rally(), lost());
      } else if (hasFence) {
        lost().add("fence and rally points: --fence names the file for them");
      }
      settle();
      String mission = PlanXml.mission(plan.home(), goals);
      write(target(".xml"), mission, goals.size() + " goals");
      if (!fenceText.isEmpty()) {
        write(
            fence().get(),
            fenceText,
            plan.areas().size() + " areas, " + plan.rally().size() + " rally points");
      }
      return ExitCode.DONE;
    }

    private List<GoalInformation> goals(StationPlan plan) {
      try {
        return ItemGoals.of(plan, lost(), lost()).goals();
      } catch (IllegalArgumentException e) { // names field, value and range
        throw new BadInputException(file() + ": " + e.getMessage(), e);
      }
    }
  }
}
