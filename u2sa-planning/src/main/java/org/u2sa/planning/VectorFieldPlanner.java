package org.u2sa.planning;

import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.planning.guidance.GuidanceLaw;
import org.u2sa.planning.guidance.LineGuidance;
import org.u2sa.planning.guidance.WaypointGuidance;
import org.u2sa.service.ServiceContext;

/**
 * A {@link PathPlanner} that follows lines by a vector field instead of a point on the line: far
 * from the line, it returns at a configured angle. Same inputs and outputs; either can replace the
 * other in motion.
 */
public final class VectorFieldPlanner extends PathPlanner {
  private record Field(
      @Variable(unit = "deg", min = 5, max = 90, ifAbsent = 60)
          @Description("Angle at which a vehicle far off the line returns to it.")
          double interceptAngle) {}

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
