package org.u2sa.core.planning;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.GoalInformation;
import org.u2sa.messages.NavigationPoint;

/**
 * One step of a pursuit.
 *
 * @param points where the subsystems are to go, one point each; none says that they are to stop
 * @param progress how the goal stands
 * @param remark what an operator should read of it in the log, and why if it is given up; empty if
 *     nothing
 * @param changed the goal with the fields that the pursuit changed (thesis 4.2.1.3: shots fired,
 *     time of arrival), which the report carries back; empty if it changed none
 */
public record Plan(
    List<NavigationPoint> points,
    Progress progress,
    String remark,
    Optional<GoalInformation> changed) {
  /** How a goal stands. */
  public enum Progress {
    /** Neither reached nor given up. */
    UNDER_WAY,
    /** Reached; reported to the Mission Manager as completed. */
    COMPLETED,
    /** Given up; reported to the Mission Manager as abandoned. */
    ABANDONED
  }

  /** A step that changes nothing in the goal. */
  public Plan(List<NavigationPoint> points, Progress progress, String remark) {
    this(points, progress, remark, Optional.empty());
  }

  /** The same step of a pursuit that changed fields of its goal. */
  public Plan changing(GoalInformation goal) {
    return new Plan(points, progress, remark, Optional.of(goal));
  }

  /** The pursuit goes on. */
  public static Plan underWay(List<NavigationPoint> points) {
    return new Plan(points, Progress.UNDER_WAY, "");
  }
}
