package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * A {@link PathPlanner} that follows lines by a field of courses instead of a point on the line: it
 * returns from far off at a configured angle. In and out as there; either may replace the other in
 * motion.
 */
public final class VectorFieldPlanner extends PathPlanner {
  private record Field(
      @Variable(
              unit = "deg",
              min = 5,
              max = 90,
              ifAbsent = 60,
              text = "Angle at which a vehicle far off the line returns to it.")
          double interceptAngle) {}

  /** Called by the launcher. */
  public VectorFieldPlanner(ServiceContext context) {
    super(context, VectorFieldPlanner::guidance);
  }

  private static WaypointGuidance guidance(PathPlanner planner) {
    Settings<Field> field = planner.settings(Field.class);
    return new LineGuidance(
        planner::lines,
        GuidanceLaw.vectorField(() -> Math.toRadians(field.get().interceptAngle())));
  }
}
