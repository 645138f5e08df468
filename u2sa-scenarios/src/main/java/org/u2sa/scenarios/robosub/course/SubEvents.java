package org.u2sa.scenarios.robosub.course;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;

/**
 * Collects events of a dive from the services' logs and reports: why goals were given up, why the
 * vehicle was stopped, and how many recognised objects the current goals needed (thesis 4.3.2).
 */
final class SubEvents {
  private static final Pattern SEEN = Pattern.compile("(\\d+); not sought by the goal (\\d+)");

  private final Map<String, String> troubles = new LinkedHashMap<>(); // by text without numbers
  private final Map<String, Integer> processed = new TreeMap<>(); // by detector
  private final Map<String, Integer> skipped = new TreeMap<>();
  private boolean isStopped;
  private String completed = ""; // UID of the newest completed goal

  List<Channel<?>> listensTo() {
    return List.of(Channels.HEALTH, Channels.FAILSAFE);
  }

  void reported(GoalInformation report) {
    if (report.completed()) {
      completed = report.uid();
    }
    if (report.abandoned()) {
      add("goal \"" + report.uid() + "\" " + report.reason().orElse("abandoned"));
    }
  }

  /** Counts a message; returns false if it is of another kind. */
  boolean heard(U2SAData data) {
    if (data instanceof HealthReport health) {
      for (String remark : health.remarks()) {
        Matcher matcher = SEEN.matcher(remark);
        if (matcher.find()) {
          processed.put(health.serviceName(), Integer.parseInt(matcher.group(1)));
          skipped.put(health.serviceName(), Integer.parseInt(matcher.group(2)));
        }
      }
    } else if (data instanceof FailsafeState failsafe) {
      isStopped = failsafe.action() == FailsafeAction.STOP;
      if (failsafe.action() != FailsafeAction.CONTINUE) {
        add("failsafe " + failsafe.action() + ": " + String.join("; ", failsafe.causes()));
      }
    } else {
      return false;
    }
    return true;
  }

  private void add(String trouble) {
    troubles.putIfAbsent(trouble.replaceAll("[0-9.]+", ""), trouble);
  }

  /** Whether the layout's last goal is completed, which ends the run. */
  boolean isComplete(SubCourse course) {
    List<CourseTask> tasks = course.tasks();
    List<CourseTask.Goal> goals = tasks.get(tasks.size() - 1).goals();
    return goals.get(goals.size() - 1).name().equals(completed);
  }

  /** Whether a failsafe has stopped the thrusters. */
  boolean isStopped() {
    return isStopped;
  }

  /** Reasons for an incomplete run, in words, in order of appearance. */
  List<String> troubles() {
    return List.copyOf(troubles.values());
  }

  private static int sum(Map<String, Integer> byDetector) {
    return byDetector.values().stream().mapToInt(Integer::intValue).sum();
  }

  /** Number of objects that the detection services published and omitted. */
  Map<String, Integer> counts() {
    Map<String, Integer> counts = new LinkedHashMap<>();
    counts.put("objectsProcessed", sum(processed));
    counts.put("objectsSkipped", sum(skipped));
    return counts;
  }
}
