package org.u2sa.core.planning;

import java.util.List;
import org.u2sa.messages.NavigationPoint;

/**
 * One step of a pursuit.
 *
 * @param points where the subsystems are to go, one point each; none says that they are to stop
 * @param progress how the goal stands
 * @param remark what an operator should read of it in the log; empty if nothing
 */
public record Plan(List<NavigationPoint> points, Progress progress, String remark) {
  /** How a goal stands. */
  public enum Progress {
    /** Neither reached nor given up. */
    UNDER_WAY,
    /** Reached; reported to the Mission Manager as completed. */
    COMPLETED,
    /** Given up; reported to the Mission Manager as abandoned. */
    ABANDONED
  }

  /** The pursuit goes on. */
  public static Plan underWay(List<NavigationPoint> points) {
    return new Plan(points, Progress.UNDER_WAY, "");
  }
}
