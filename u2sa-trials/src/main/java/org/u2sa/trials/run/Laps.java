package org.u2sa.trials.run;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalDouble;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.mission.Home;
import org.u2sa.mission.Mission;
import org.u2sa.report.EscapedXml;

/**
 * Repeats the waypoints of a mission for several laps, in file order. The resulting mission
 * terminates, so a run can be scored.
 */
public final class Laps {
  private Laps() {}

  /**
   * Writes the mission to a file.
   *
   * @param laps at least 1
   * @param leastThresholdM minimum threshold of the waypoints [m]
   * @return the mission in the file
   * @throws BadInputException if a goal is not a waypoint in earth coordinates, or if several laps
   *     are requested of a mission with explicit successors
   */
  public static Mission write(Mission mission, int laps, double leastThresholdM, Path file) {
    Home home = RunPlans.home(mission);
    if (laps > 1) {
      refuseLinks(mission);
    }
    StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.append("<!-- ").append(laps).append(" times round the waypoints of a mission. -->\n");
    text.append("<mission>\n");
    GoalLinksXml.limit(text, mission);
    text.append("  <home>\n");
    number(text, "x", OptionalDouble.of(home.x()));
    number(text, "y", OptionalDouble.of(home.y()));
    number(text, "z", home.z());
    home.headingRad().ifPresent(rad -> number(text, "psi", OptionalDouble.of(Math.toDegrees(rad))));
    text.append("  </home>\n");
    for (int lap = 1; lap <= laps; lap++) {
      for (GoalInformation goal : mission.goals()) {
        waypoint(text, waypoint(mission, goal), name(goal, lap), leastThresholdM, laps == 1);
      }
    }
    try {
      Files.createDirectories(file.toAbsolutePath().getParent());
      Files.writeString(file, text.append("</mission>\n"));
    } catch (IOException e) {
      throw new RunFailedException("cannot write " + file + ": " + e.getMessage(), e);
    }
    return Mission.load(file);
  }

  private static void refuseLinks(Mission mission) {
    for (int i = 0; i < mission.goals().size(); i++) {
      if (GoalLinksXml.hasLinks(mission.goals().get(i))) {
        throw mission.goalError(
            i, "defines its successors, so laps in file order are impossible; expected 1 lap");
      }
    }
  }

  /** The first lap keeps the mission's names. */
  private static String name(GoalInformation goal, int lap) {
    return lap == 1 ? goal.uid() : goal.uid() + ", lap " + lap;
  }

  private static Waypoint waypoint(Mission mission, GoalInformation goal) {
    boolean driven =
        goal instanceof Waypoint waypoint
            && waypoint.referenceFrame().equals(ReferenceFrame.GLOBAL)
            && waypoint.x().isPresent()
            && waypoint.y().isPresent();
    if (!driven) {
      throw new BadInputException(
          mission.origin()
              + ": goal \""
              + goal.uid()
              + "\": the demo expects waypoints in Global with x and y only");
    }
    return (Waypoint) goal;
  }

  private static void waypoint(
      StringBuilder text,
      Waypoint waypoint,
      String name,
      double leastThresholdM,
      boolean withLinks) {
    double threshold = Math.max(leastThresholdM, waypoint.horizontalThreshold());
    text.append("  <waypoint>\n    <name>").append(EscapedXml.of(name)).append("</name>\n");
    number(text, "x", waypoint.x());
    number(text, "y", waypoint.y());
    number(text, "z", waypoint.z());
    number(text, "horizontalThreshold", OptionalDouble.of(threshold));
    number(text, "speed", waypoint.speed());
    number(text, "psi", waypoint.psi());
    if (withLinks) {
      number(text, "time", waypoint.time());
      GoalLinksXml.links(text, waypoint);
    }
    text.append("  </waypoint>\n");
  }

  private static void number(StringBuilder text, String name, OptionalDouble value) {
    if (value.isPresent()) {
      text.append(String.format(Locale.ROOT, "    <%s>%s</%s>\n", name, value.getAsDouble(), name));
    }
  }
}
