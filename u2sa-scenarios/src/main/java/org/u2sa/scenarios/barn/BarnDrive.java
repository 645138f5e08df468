package org.u2sa.scenarios.barn;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.cli.Main;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.messages.frame.Geodetic;

/** Drives one course with {@code demo ugv} in this process and scores it by ground truth. */
final class BarnDrive {
  private static final double STARTED_M = 0.1;
  private static final Pattern CONTACTS = Pattern.compile("\"contacts\"\\s*:\\s*(\\d+)");

  private BarnDrive() {}

  /**
   * Drives the course.
   *
   * @param folder folder for world, mission and the demo's files
   * @param options further options of the demo
   */
  static BarnScore drive(BarnCourse course, Path folder, List<String> options) throws IOException {
    Files.createDirectories(folder);
    Path world = folder.resolve("world.xml");
    Path mission = folder.resolve("mission.xml");
    course.writeWorld(world);
    course.writeMission(mission);
    Path out = folder.resolve("out");
    List<String> arguments = new ArrayList<>(List.of("demo", "ugv", "--port", "0"));
    arguments.addAll(List.of("--world", world.toString(), "--mission", mission.toString()));
    arguments.addAll(List.of("--out", out.toString()));
    arguments.addAll(options);
    StringWriter said = new StringWriter();
    Main.run(new PrintWriter(said), new PrintWriter(said), arguments.toArray(String[]::new));
    Files.writeString(folder.resolve("said.txt"), said.toString());
    Path summary = out.resolve("summary.json");
    if (!Files.exists(summary)) {
      throw new RunFailedException("world " + course.world().number() + ": " + said);
    }
    Matcher contacts = CONTACTS.matcher(Files.readString(summary));
    return score(
        course,
        Files.readAllLines(out.resolve("track.csv")),
        contacts.find() ? Integer.parseInt(contacts.group(1)) : 0);
  }

  /**
   * Scores a drive.
   *
   * @param track lines of {@code track.csv} (ground truth): time, longitude and latitude first
   */
  static BarnScore score(BarnCourse course, List<String> track, int contacts) {
    double startedS = Double.NaN;
    double lastS = 0.0;
    OptionalDouble reachedS = OptionalDouble.empty();
    for (String line : track.subList(1, track.size())) {
      String[] fields = line.split(",");
      lastS = Double.parseDouble(fields[0]);
      Geodetic at = new Geodetic(Double.parseDouble(fields[1]), Double.parseDouble(fields[2]), 0.0);
      if (Double.isNaN(startedS) && at.distanceM(course.start()) >= STARTED_M) {
        startedS = lastS;
      }
      if (reachedS.isEmpty() && at.distanceM(course.goal()) <= course.reachedM()) {
        reachedS = OptionalDouble.of(lastS);
      }
    }
    BarnScore.Outcome outcome =
        contacts > 0
            ? BarnScore.Outcome.TOUCHED
            : reachedS.isPresent() ? BarnScore.Outcome.REACHED : BarnScore.Outcome.NOT_REACHED;
    double fromS = Double.isNaN(startedS) ? 0.0 : startedS;
    return new BarnScore(
        course.world().number(), course.pathM(), outcome, reachedS.orElse(lastS) - fromS);
  }
}
