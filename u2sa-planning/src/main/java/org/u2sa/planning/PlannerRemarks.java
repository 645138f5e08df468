package org.u2sa.planning;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.planning.guidance.WaypointAccuracy;
import org.u2sa.service.U2SAService;

/** What a planner tells its operator about the current goal; a lasting problem is told once. */
final class PlannerRemarks {
  private final U2SAService planner;
  private final Supplier<Optional<GoalInformation>> goal;
  private String complaint = ""; // last one logged, to log it once
  private String threshold = ""; // last remark on the current goal's threshold

  /**
   * @param goal the goal being pursued; empty if none is
   */
  PlannerRemarks(U2SAService planner, Supplier<Optional<GoalInformation>> goal) {
    this.planner = planner;
    this.goal = goal;
  }

  /** Reports a problem of the current goal, also in health. */
  void trouble(String what) {
    planner.trouble(goal.get().map(pursued -> named(pursued) + ": ").orElse("") + what);
  }

  /**
   * Logs what happens to the current goal.
   *
   * @param isTrouble whether it is also reported in health
   */
  void say(String what, boolean isTrouble) {
    String line = "goal \"" + goal.get().map(GoalInformation::uid).orElse("") + "\": " + what;
    if (isTrouble) {
      planner.trouble(line);
    } else {
      planner.log(LogLevelEnum.WARN, line);
    }
  }

  /** Reports once that the current goal cannot be planned, also in health. */
  void refuse(String what) {
    String key = "no plan for " + goal.get().map(GoalInformation::uid).orElse("the end");
    if (!complaint.equals(key)) {
      planner.trouble(what);
      complaint = key;
    }
  }

  /** Logs a problem once until it is resolved. */
  void complain(String what, String key) {
    if (!complaint.equals(key)) {
      planner.log(LogLevelEnum.WARN, what);
      complaint = key;
    }
  }

  /** A goal was planned. */
  void resolved() {
    complaint = "";
  }

  /** Warns at the start of a goal if the state is too inaccurate for its threshold. */
  void judgeThreshold(GoalInformation begun, StateInformation state) {
    String said = WaypointAccuracy.remark(begun, state).orElse("");
    if (threshold.isEmpty() && !said.isEmpty()) {
      planner.trouble(said); // once; the remark covers the others
    }
    threshold = said;
    planner.remark("threshold", said);
  }

  static String named(GoalInformation goal) {
    return "goal \"" + goal.uid() + "\"";
  }
}
