package org.u2sa.scenarios.robosub.course;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.u2sa.mission.Mission;
import org.u2sa.report.ReportFile;

/**
 * Writes a layout's mission, containing the information given to a team: the tasks in order, and
 * the types of their objects. Each goal also lists the objects of possible next goals, so that
 * these are mapped in advance.
 */
public final class SubMission {
  private SubMission() {}

  /** Writes the mission of a layout. */
  public static Mission write(SubCourse course, Path file) {
    StringBuilder text =
        new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<mission>\n");
    text.append("  <home><x>").append(SubCourse.ORIGIN.longitudeDeg());
    text.append("</x><y>").append(SubCourse.ORIGIN.latitudeDeg());
    text.append("</y><z>0</z><psi>0</psi></home>\n");
    for (int i = 0; i < course.stages().size(); i++) {
      List<CourseTask.Goal> later =
          i + 1 < course.stages().size()
              ? course.stages().get(i + 1).stream()
                  .map(task -> task.goals().get(0))
                  .collect(Collectors.toList())
              : List.of();
      course.stages().get(i).forEach(task -> write(task.goals(), later, text));
    }
    text.append("</mission>\n");
    ReportFile.writeText(file, out -> out.write(text.toString()));
    return Mission.load(file);
  }

  private static void write(
      List<CourseTask.Goal> goals, List<CourseTask.Goal> later, StringBuilder text) {
    for (int i = 0; i < goals.size(); i++) {
      CourseTask.Goal goal = goals.get(i);
      List<CourseTask.Goal> next = i + 1 < goals.size() ? List.of(goals.get(i + 1)) : later;
      List<String> types = new ArrayList<>(goal.objectTypes());
      next.forEach(each -> types.addAll(each.objectTypes()));
      text.append("  <").append(goal.element()).append("><name>").append(goal.name());
      text.append("</name><objectTypes>").append(String.join(", ", types)).append("</objectTypes>");
      if (!next.isEmpty()) {
        text.append("<next>");
        text.append(next.stream().map(CourseTask.Goal::name).collect(Collectors.joining(", ")));
        text.append("</next>");
      }
      text.append("</").append(goal.element()).append(">\n");
    }
  }
}
