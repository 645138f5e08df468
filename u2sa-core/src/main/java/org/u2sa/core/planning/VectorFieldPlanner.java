package org.u2sa.core.planning;

import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.service.ServiceContext;

/**
 * A {@link PathPlanner} that follows lines by a field of courses instead of a point on the line:
 * far off the line it comes back at an angle that can be set. In and out as there; either takes the
 * other's place in motion.
 */
public final class VectorFieldPlanner extends PathPlanner {
  static final VariableDeclaration<Double> INTERCEPT_ANGLE =
      VariableDeclaration.number("INTERCEPT ANGLE", "deg")
          .range(Range.of(5.0, 90.0))
          .ifAbsent(60.0)
          .describedAs("Course relative to the line at which a vehicle far off comes back to it.");

  /** Called by the launcher. */
  public VectorFieldPlanner(ServiceContext context) {
    super(context, VectorFieldPlanner::guidance);
  }

  private static WaypointGuidance guidance(PathPlanner planner) {
    planner.getVariable(INTERCEPT_ANGLE); // a wrong value must fail before the flight
    return new LineGuidance(
        planner::lines,
        new VectorFieldLaw(() -> Math.toRadians(planner.getVariable(INTERCEPT_ANGLE))));
  }
}
