package org.u2sa.planning;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.goal.GoalInformation;

/**
 * One step of a pursuit.
 *
 * @param points navigation points, one per subsystem; none to stop
 * @param progress progress of the goal
 * @param remark remark for the operator's log, including the reason for giving up; empty if none
 * @param changed goal with the fields changed by the pursuit (thesis 4.2.1.3: shots fired, time of
 *     arrival), returned in the report; empty if unchanged
 */
public record Plan(
    List<NavigationPoint> points,
    Progress progress,
    String remark,
    Optional<GoalInformation> changed) {
  public enum Progress {
    /** Neither reached nor abandoned. */
    UNDER_WAY,
    /** Reached; reported to the Mission Manager as completed. */
    COMPLETED,
    /** Given up; reported to the Mission Manager as abandoned. */
    ABANDONED
  }

  /** Creates a step that leaves the goal unchanged. */
  public Plan(List<NavigationPoint> points, Progress progress, String remark) {
    this(points, progress, remark, Optional.empty());
  }

  public Plan changing(GoalInformation goal) {
    return new Plan(points, progress, remark, Optional.of(goal));
  }

  /** Creates a step that abandons the goal for a reason or, without one, continues. */
  static Plan unless(Optional<String> givenUp, List<NavigationPoint> points) {
    return givenUp
        .map(reason -> new Plan(points, Progress.ABANDONED, "given up: " + reason))
        .orElseGet(() -> underWay(points));
  }

  /** Creates a step of a pursuit that continues. */
  public static Plan underWay(List<NavigationPoint> points) {
    return new Plan(points, Progress.UNDER_WAY, "");
  }
}
