package org.u2sa.mission;

import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalResult;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.ObeyedOrders;

/**
 * Executes what other services send about goals: the planner's reports, updates of goals and
 * commands to change to one. Each counts once, however often it arrives. Confined to the manager's
 * thread.
 */
final class GoalMessages {
  private static final String OBEYED = "OBEYED COMMANDS AND UPDATES"; // in the hand-over
  private static final long REPEAT_EVERY_MICROS = Clock.MICROS_PER_SECOND;
  private static final long ALWAYS_LOGGED = 100; // later ones at 128, 256, 512…

  private final MissionRun run;
  private final Logger logger;
  private final Function<U2SAData, Optional<String>> lateness;
  private final Runnable passTime;
  private final Runnable publish;
  private final Runnable repeat;
  private final ObeyedOrders obeyed = new ObeyedOrders(); // goal commands and updates
  private final Map<String, Long> reportedMicros = new HashMap<>(); // latest report by goal
  private long repeatDueMicros; // of the current goals, for a planner unaware of them
  private long ignored; // reports and updates

  /**
   * @param lateness reason for refusing a message that arrived too late
   * @param passTime lets the time limits of goals pass before their order changes
   * @param publish publishes goals that have changed
   * @param repeat publishes the same goals to a planner that may have missed them
   */
  GoalMessages(
      MissionRun run,
      Logger logger,
      Function<U2SAData, Optional<String>> lateness,
      Runnable passTime,
      Runnable publish,
      Runnable repeat) {
    this.run = run;
    this.logger = logger;
    this.lateness = lateness;
    this.passTime = passTime;
    this.publish = publish;
    this.repeat = repeat;
  }

  void handOver(HandOver state) {
    state.texts(OBEYED, obeyed.identities());
  }

  void takeOver(HandOver state) {
    obeyed.takeOver(state.texts(OBEYED));
  }

  /** Another mission begins, whose goals may have the same names. */
  void beginMission() {
    reportedMicros.clear();
  }

  /** Executes the report of a goal that was completed or abandoned. */
  void finish(GoalInformation goal) {
    String uid = goal.uid();
    GoalResult result = goal.completed() ? GoalResult.DONE : GoalResult.FAILED;
    boolean current = run.progress().pursued().currentNames().contains(uid);
    boolean known = run.progress().pursued().knows(uid); // others' times are not kept
    if (!known
        || isRepeated(goal)
        || !run.progress()
            .finish(uid, result, Optional.of(goal), "abandoned by the planner", run.micros())) {
      String what = current ? "has already arrived" : known ? "is not current" : "is not known";
      ignore("report of goal \"" + uid + "\" ignored: it " + what);
      if (known) {
        repeatGoals();
      }
      return;
    }
    if (goal.completed()) {
      info("goal \"" + uid + "\" completed");
    } else {
      String why = goal.reason().map(text -> ": " + text).orElse("");
      warn("goal \"" + uid + "\" abandoned by the planner" + why);
    }
    publish.run();
  }

  /**
   * Whether a report with this goal and time has already arrived: duplicated by the network, or
   * repeated by a planner until answered. In a loop each would count as another lap. False without
   * a time.
   */
  private boolean isRepeated(GoalInformation report) {
    return report.timestamp().isPresent()
        && Objects.equals(
            reportedMicros.put(report.uid(), report.timestamp().getAsLong()),
            report.timestamp().getAsLong());
  }

  /** Rate-limited: a permanent disagreement causes no flood, and planners repeat their reports. */
  private void repeatGoals() {
    long now = run.micros();
    if (now >= repeatDueMicros) {
      repeatDueMicros = now + REPEAT_EVERY_MICROS;
      repeat.run();
    }
  }

  /** Changes or adds a goal. */
  void update(GoalInformation goal) {
    Optional<String> late = lateness.apply(goal);
    if (late.isPresent()) {
      ignore("update of goal \"" + goal.uid() + "\" refused: " + late.get());
      return;
    }
    if (!obeyed.add("", goal)) {
      ignore("update of goal \"" + goal.uid() + "\" ignored: it has already arrived");
      return;
    }
    GoalSequence updated = run.progress().knowing(goal.uid());
    if (!updated.book.hasRoomForUpdate(goal)) {
      ignore(
          "update of goal \"" + goal.uid() + "\" refused: the goals would be too long to publish");
      return;
    }
    Optional<String> lack = updated.book.lackAfter(goal);
    if (lack.isPresent()) {
      ignore("update of goal \"" + goal.uid() + "\" refused: it " + lack.get());
      return;
    }
    if (updated.update(goal)) {
      info("goal \"" + goal.uid() + "\" updated");
    } else {
      String fate = "it is not pursued until another goal's next names it, or it is commanded";
      warn("goal \"" + goal.uid() + "\" added; " + fate);
    }
    publish.run();
  }

  /** Changes to a goal on command. */
  void changeTo(GoalCommand command) {
    String uid = command.uid();
    Optional<String> refusal = refusal(command);
    if (refusal.isPresent()) {
      warn("command to change to goal \"" + uid + "\" " + refusal.get());
      return;
    }
    passTime.run();
    run.progress().changeTo(uid);
    info("changing to goal \"" + uid + "\" on command");
    publish.run();
  }

  private Optional<String> refusal(GoalCommand command) {
    Optional<String> late = lateness.apply(command);
    if (late.isPresent()) {
      return late.map("rejected: "::concat);
    }
    if (!obeyed.add("", command)) {
      return Optional.of("ignored: it came twice");
    }
    if (!run.progress().pursued().knows(command.uid())) {
      return Optional.of("rejected: unknown");
    }
    return run.objection().map("rejected: "::concat);
  }

  /** Logs rejected messages from others, rate-limited. */
  private void ignore(String what) {
    ignored++;
    if (ignored <= ALWAYS_LOGGED || Long.bitCount(ignored) == 1) {
      warn(what + (ignored <= ALWAYS_LOGGED ? "" : " (" + ignored + " so far)"));
    }
  }

  private void info(String what) {
    logger.log(LogLevelEnum.INFO, what);
  }

  private void warn(String what) {
    logger.log(LogLevelEnum.WARN, what);
  }
}
