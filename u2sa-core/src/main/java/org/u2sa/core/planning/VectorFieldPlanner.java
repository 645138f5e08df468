package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.service.ServiceContext;

/**
 * A {@link PathPlanner} that follows lines by a field of courses instead of a point on the line:
 * far off the line it comes back at an angle that can be set. In and out as there; either takes the
 * other's place in motion.
 */
public final class VectorFieldPlanner extends PathPlanner {
  private record Field(
      @Variable(
              unit = "deg",
              min = 5,
              max = 90,
              ifAbsent = 60,
              text = "Course relative to the line at which a vehicle far off comes back to it.")
          double interceptAngle) {}

  /** Called by the launcher. */
  public VectorFieldPlanner(ServiceContext context) {
    super(context, VectorFieldPlanner::guidance);
  }

  private static WaypointGuidance guidance(PathPlanner planner) {
    Settings<Field> field = planner.settings(Field.class);
    return new LineGuidance(
        planner::lines, new VectorFieldLaw(() -> Math.toRadians(field.get().interceptAngle())));
  }
}
