package org.u2sa.report.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.report.page.Trace;

/** Timeline of a run: events, and the condition of each service. */
final class RunTimeline {
  private record Event(double timeS, String kind, boolean bad, String text) {}

  private final List<Event> events = new ArrayList<>();
  private final Map<String, List<JsonText>> conditions = new TreeMap<>();
  private final Map<String, String> lastOf = new HashMap<>(); // last text by subject
  private final Set<String> notAlive = new HashSet<>(); // services
  private int changes; // of all conditions
  private long leftOut;

  void take(double timeS, U2SAData message) {
    if (message instanceof FailsafeState state) {
      String causes = String.join("; ", state.causes());
      boolean bad = state.action() != FailsafeAction.CONTINUE;
      change(timeS, "failsafe", "failsafe", bad, state.action() + (bad ? ": " + causes : ""));
    } else if (message instanceof ArmingState state) {
      change(timeS, "arming", "arming", false, state.armed() ? "armed" : "disarmed");
    } else if (message instanceof EmergencyStop stop) {
      String text =
          (stop.active() ? "emergency stop: " : "emergency stop cleared: ") + stop.reason();
      change(timeS, "stop", "stop", stop.active(), text);
    } else if (message instanceof GoalInformation goal) {
      take(timeS, goal);
    } else if (message instanceof ServiceCondition condition) {
      take(timeS, condition);
    } else if (message instanceof HealthReport report) {
      Optional<String> error = report.lastError();
      error.ifPresent(
          text ->
              change(
                  timeS,
                  "error " + report.serviceName(),
                  "error",
                  true,
                  report.serviceName() + ": " + text));
    } else if (message instanceof ConfigurationTransactionResult result && result.accepted()) {
      for (ConfigurationAssignment each : result.assignments()) {
        String from = each.previous().map(previous -> previous + " → ").orElse("");
        add(
            timeS,
            "configuration",
            false,
            result.serviceName()
                + " "
                + each.variableName()
                + ": "
                + from
                + each.value()
                + ", by "
                + result.author());
      }
    }
  }

  private void take(double timeS, GoalInformation goal) {
    if (goal.completed() || goal.abandoned()) {
      String why = goal.reason().map(reason -> ": " + reason).orElse("");
      String how = goal.abandoned() ? "abandoned" : "reached";
      change(
          timeS,
          "goal " + goal.uid(),
          "goal",
          goal.abandoned(),
          "goal " + goal.uid() + " " + how + why);
    }
  }

  private void take(double timeS, ServiceCondition condition) {
    String name = ReportLimits.clipped(condition.serviceName());
    String text = condition.condition().name();
    if (!isNews("condition " + name, text)) {
      return;
    }
    if (++changes > ReportLimits.MAX_CHANGES) {
      leftOut++;
      return;
    }
    List<JsonText> row = conditions.computeIfAbsent(name, key -> new ArrayList<>());
    row.add(new JsonText().put("t", Trace.rounded(timeS)).put("condition", text));
    if (condition.condition() != Condition.ALIVE && condition.condition() != Condition.STOPPED) {
      notAlive.add(name);
    }
    if (row.size() > 1 || !text.equals("ALIVE")) {
      boolean bad = !text.equals("ALIVE");
      String action = condition.action().isEmpty() ? "" : " (" + condition.action() + ")";
      add(timeS, "condition", bad, name + " is " + text + ": " + condition.reason() + action);
    }
  }

  private void change(double timeS, String subject, String kind, boolean bad, String text) {

    if (isNews(ReportLimits.clipped(subject), ReportLimits.clipped(text))) {
      add(timeS, kind, bad, text);
    }
  }

  /** Whether a subject's text has changed; the number of remembered subjects is limited. */
  private boolean isNews(String subject, String text) {
    if (lastOf.size() >= ReportLimits.MAX_SUBJECTS && !lastOf.containsKey(subject)) {
      leftOut++;
      return false;
    }
    return !text.equals(lastOf.put(subject, text));
  }

  void add(double timeS, String kind, boolean bad, String text) {
    if (events.size() >= ReportLimits.MAX_EVENTS) {
      leftOut++;
      return;
    }
    events.add(new Event(timeS, kind, bad, ReportLimits.clipped(text)));
  }

  /** Number of services that were neither alive nor stopped at some time. */
  long servicesNotAlive() {
    return notAlive.size();
  }

  long count(String kind, boolean bad) {
    return events.stream().filter(e -> e.kind().equals(kind) && e.bad() == bad).count();
  }

  JsonText json() {
    events.sort(Comparator.comparingDouble(Event::timeS));
    List<JsonText> all = new ArrayList<>();
    for (Event event : events) {
      all.add(
          new JsonText()
              .put("t", Math.round(event.timeS() * 1e3) / 1e3)
              .put("kind", event.kind())
              .put("bad", event.bad())
              .put("text", event.text()));
    }
    List<JsonText> rows = new ArrayList<>();
    conditions.forEach(
        (name, changes) -> rows.add(new JsonText().put("service", name).put("changes", changes)));
    return new JsonText().put("events", all).put("leftOut", leftOut).put("conditions", rows);
  }
}
